#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/energy/wall_energy.hpp"
#include "wirepack/observe/coil_report.hpp"
#include "wirepack/packing/dynamic_packing.hpp"
#include "wirepack/packing/quasistatic_packing.hpp"
#include "wirepack/packing/work_balance.hpp"
#include "wirepack/solve/stability.hpp"

#include "../support/sample_rods.hpp"

namespace wirepack {
namespace {

constexpr Index edges = 120;

// A loop of a wire that hardly stretches, on a wall that hardly gives way.
RodState rest_of_loop(const Cavity& cavity, double length, const Points& start) {
  RodParams wire;
  wire.edge_length = length / static_cast<double>(edges);
  wire.stretch_multiplier = 100;
  RodState loop = make_rod(start, wire, {.closed = true});
  const StretchEnergy stretch(wire);
  const JointEnergy joints(wire);
  const WallEnergy wall(wire, cavity, 50);
  const double bend = stiffness(wire).bend, tolerance = 1e-6 * bend / (length * length);
  const EquilibriumReport report =
      solve_stable_equilibrium(loop, HeldUnknowns::none(loop), EnergyTerms{stretch, joints, wall},
                               equilibrium_options(bend, length, tolerance), 1);
  EXPECT_EQ(report.end, EquilibriumEnd::converged);
  return loop;
}

// A circle about the z axis that leaves its plane by z(angle).
template <class Height>
Points circle(double radius, Height&& height) {
  Points nodes(3, edges);
  for (Index i = 0; i < edges; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(edges);
    nodes.col(i) = Vec3(radius * std::cos(angle), radius * std::sin(angle), height(angle));
  }
  return nodes;
}

// Amplitude of the m-th wave of z about the z axis.
double wave(const RodState& loop, int m) {
  double cosine = 0, sine = 0;
  for (Index i = 0; i < edges; ++i) {
    const double angle = m * std::atan2(loop.nodes(1, i), loop.nodes(0, i));
    cosine += loop.nodes(2, i) * std::cos(angle) * 2 / edges;
    sine += loop.nodes(2, i) * std::sin(angle) * 2 / edges;
  }
  return std::hypot(cosine, sine);
}

// On a wall of revolution whose sections through the axis have the radius of curvature q at the
// equator of radius p, z = A cos(m angle) makes a loop longer by pi A^2 / 2 (m^2 / p - 1 / q): what
// is too long by e 2 pi p goes into the saddle m = 2 with A^2 = 4 e p^2 / (4 - p / q).
TEST(LoopInEllipsoid, that_is_longer_than_the_equator_takes_the_length_in_a_saddle_along_the_wall) {
  const double excess = 0.01, equator = 9;
  for (const double polar : {8.0, 9.0, 10.0}) {
    const double sectional = polar * polar / 10 - 1;
    const double expected = equator * std::sqrt(4 * excess / (4 - equator / sectional));
    const RodState loop =
        rest_of_loop(ellipsoid(Vec3(10, 10, polar)), 2 * pi * equator * (1 + excess),
                     circle(equator, [](double angle) { return 0.5 * std::cos(2 * angle); }));
    EXPECT_NEAR(wave(loop, 2), expected, 0.03 * expected) << polar;
  }
}

TEST(LoopInEllipsoid, turns_to_the_equator_of_an_oblate_one_and_to_a_meridian_of_a_prolate_one) {
  const auto tilted = [](double radius) {
    return circle(radius, [radius](double angle) { return 0.4 * radius * std::cos(angle); });
  };
  const auto reach = [](const RodState& loop) { return loop.nodes.row(2).cwiseAbs().maxCoeff(); };
  // longer than the equator of the centreline by nothing, than a meridian's ellipse by a lot
  EXPECT_LT(reach(rest_of_loop(ellipsoid(Vec3(10, 10, 8)), 2 * pi * 9, tilted(8.5))), 0.1);
  const RodState along = rest_of_loop(ellipsoid(Vec3(8, 8, 10)), 2 * pi * 8, tilted(7));
  EXPECT_GT(reach(along), 8.5);
}

double coil_axis_along(const RodState& rod, const Vec3& direction) {
  return coil_report(rod, direction).feed_alignment;
}

class OblateEllipsoid : public ::testing::TestWithParam<Setup> {};

// The nozzle is at the end of a long axis; in a sphere the axis of the coils has no reason to be x.
TEST_P(OblateEllipsoid,
       in_an_oblate_ellipsoid_coils_lie_around_its_short_axis_and_work_is_accounted) {
  Scenario scenario = default_scenario(GetParam(), ellipsoid(Vec3(8, 10, 10)));
  scenario.stop = {};
  scenario.stop.density = 0.06;
  QuasistaticPacking packing(scenario);
  while (!packing.advance().stop) {
  }
  const PackingProgress& progress = packing.progress();
  EXPECT_GE(progress.last.packing_density, 0.06);
  EXPECT_LE(progress.last.residual, 1e-4);
  EXPECT_LT(progress.last.max_overlap, 0.2);
  EXPECT_LT(std::abs(residue(progress.balance, progress.last)), 0.01 * progress.balance.work);
  EXPECT_GT(coil_axis_along(progress.rod, Vec3::UnitX()), 0.8);
}
INSTANTIATE_TEST_SUITE_P(BothSetups, OblateEllipsoid,
                         ::testing::Values(Setup::low_torsion, Setup::high_torsion));

TEST(PackingInEllipsoid, of_equal_axes_is_the_packing_in_the_sphere) {
  const auto row = [](const Cavity& cavity) {
    Scenario scenario = default_scenario(Setup::high_torsion, cavity);
    scenario.friction.model = FrictionModel::coulomb;
    scenario.stop = {};
    scenario.stop.length = 10;  // the wire bends along the wall
    QuasistaticPacking packing(scenario);
    while (!packing.advance().stop) {
    }
    return packing.progress().last;
  };
  const HistoryRow sphere = row(Cavity{5}), same = row(ellipsoid(Vec3::Constant(5)));
  EXPECT_GT(sphere.energy_wall, 0);
  EXPECT_NEAR(same.energy_total, sphere.energy_total, 1e-6 * sphere.energy_total);
  EXPECT_NEAR(same.force, sphere.force, 1e-4 * std::abs(sphere.force));
}

TEST(PackingInEllipsoid, in_time_with_friction_stays_inside) {
  Scenario scenario =
      default_scenario(Setup::low_torsion, ellipsoid(Vec3(6, 5, 4.5)), 1, 5, Method::dynamic);
  scenario.stop = {};
  scenario.stop.length = 16;
  DynamicPacking packing(scenario);
  double overlap = 0;
  while (!packing.advance().stop) overlap = std::max(overlap, packing.progress().last.max_overlap);
  EXPECT_GE(packing.progress().last.inserted_length, 16 * (1 - 1e-9));
  EXPECT_GT(overlap, 0);
  EXPECT_LT(overlap, 0.5);
}

}  // namespace
}  // namespace wirepack
