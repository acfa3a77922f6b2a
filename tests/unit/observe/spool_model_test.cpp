#include "wirepack/observe/spool_model.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/core/error.hpp"
#include "wirepack/core/types.hpp"
#include "wirepack/observe/packing_density.hpp"

namespace wirepack {
namespace {

SpoolModel paper_spool() { return {Cavity{40}, 1, 5 * pi / 4, 2.81}; }

TEST(PackingDensity, IsVolumeOfWireOverVolumeOfCavity) {
  const Cavity cavity{7};
  const double length = 30, radius = 0.4;
  const double wire = pi * radius * radius * length, sphere = 4.0 / 3 * pi * 7 * 7 * 7;
  EXPECT_NEAR(packing_density(length, cavity, radius), wire / sphere, 1e-15);
  EXPECT_NEAR(length_at_density(wire / sphere, cavity, radius), length, 1e-12);
}

TEST(PackingDensity, OfOneHoopIsThatOfTheTable) {
  // V4.2: phi of a hoop of radius R - a; printed to six decimals
  const double table[][2] = {{4, .220893},  {5, .150796},  {10, .042412}, {13, .025739},
                             {20, .011192}, {40, .002872}, {50, .001847}};
  for (const auto& [r, density] : table) {
    EXPECT_NEAR(packing_density(2 * pi * (r - 1), Cavity{r}, 1), density, 5.1e-7) << r;
  }
}

TEST(SpoolModel, GivesTheTabulatedEnergiesAndForces) {
  // V4.3 at a/R = 1/40, d_s = 2.81 a: phi, E R / YI, F R^2 / YI; printed to five and six decimals
  const double table[][3] = {{.01, 11.19518, .542275},   {.05, 62.07477, .647628},
                             {.10, 138.21730, .783515},  {.20, 343.05916, 1.174816},
                             {.30, 669.79514, 2.021664}, {.40, 1366.56532, 5.669295}};
  const SpoolModel spool = paper_spool();
  for (const auto& [density, energy, force] : table) {
    EXPECT_NEAR(spool.bend_energy(density) * 40 / spool.bend_stiffness, energy, 5.1e-6);
    EXPECT_NEAR(spool.injection_force(density) * 1600 / spool.bend_stiffness, force, 5.1e-7);
  }
}

TEST(SpoolModel, ForceIsTheDerivativeOfTheEnergyByLength) {
  const SpoolModel spool = paper_spool();
  for (const double density : {1e-7, 1e-4, 0.05, 0.2, 0.4}) {
    const double h = 1e-4 * density;  // truncation h^2, rounding 1e-16 / h, both below 1e-7
    const double difference = (spool.bend_energy(density + h) - spool.bend_energy(density - h)) /
                              (2 * length_at_density(h, spool.cavity, spool.wire_radius));
    EXPECT_NEAR(difference / spool.injection_force(density), 1, 1e-6) << density;
  }
}

TEST(SpoolModel, AThinSpoolIsACoilAtTheWall) {
  const SpoolModel spool = paper_spool();
  const double density = 1e-9;
  const double length = length_at_density(density, spool.cavity, 1);
  // E = YI L / (2 R^2) up to x^2 = k phi^(2/3) ~ 2e-6
  EXPECT_NEAR(spool.bend_energy(density) / (spool.bend_stiffness * length / (2 * 1600)), 1, 1e-5);
  EXPECT_NEAR(spool.inner_radius(density), 40, 1e-4);
  EXPECT_EQ(spool.bend_energy(0), 0);
}

TEST(SpoolModel, EndsWhereHoopsReachTheAxis) {
  const SpoolModel spool = paper_spool();
  EXPECT_NEAR(spool.largest_density(), 0.4594, 5e-5);  // printed to four digits
  EXPECT_LT(spool.inner_radius(spool.largest_density() * (1 - 1e-9)), 0.01);
  // hoops at spacing d_s on hexagons fill the shell between the inner cylinder and the sphere
  const double x = 0.6, inner = 40 * std::sqrt(1 - x * x);
  const double volume = 4.0 / 3 * pi * std::pow(40 * x, 3);
  const double length = volume / (std::sqrt(3.0) / 2 * 2.81 * 2.81);
  EXPECT_NEAR(spool.inner_radius(packing_density(length, spool.cavity, 1)), inner, 1e-9);
  EXPECT_THROW(spool.bend_energy(0.46), InvalidInput);
  EXPECT_THROW(spool.injection_force(-0.1), InvalidInput);
}

}  // namespace
}  // namespace wirepack
