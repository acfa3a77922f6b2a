#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/packing/quasistatic_packing.hpp"

namespace wirepack {
namespace {

// Length that is inside when the tip of the wire first presses on the wall.
double length_at_first_contact(const Scenario& scenario) {
  QuasistaticPacking packing(scenario);
  while (packing.progress().last.force < 1e-3 * force_unit(scenario)) {
    if (packing.advance().stop) return NAN;
  }
  return packing.progress().last.inserted_length;
}

Scenario with_nozzle(const NozzleOptions& nozzle) {
  Scenario scenario = default_scenario(Setup::low_torsion, {20});
  scenario.wire.edge_length = 1;
  scenario.insertion.increment = 0.1;
  scenario.nozzle = nozzle;
  return scenario;
}

// The centreline of a tip that touches is at 19 from the centre.
TEST(Nozzle, a_straight_wire_reaches_the_wall_after_the_chord_in_front_of_it) {
  EXPECT_NEAR(length_at_first_contact(with_nozzle({})), 38, 0.11);
  EXPECT_NEAR(length_at_first_contact(with_nozzle({.depth = 7})), 31, 0.11);
  const Vec3 oblique(std::sin(pi / 4), 0, -std::cos(pi / 4));
  EXPECT_NEAR(length_at_first_contact(with_nozzle({.direction = oblique})), 38 * std::sqrt(0.5),
              0.11);
}

// Peak of the force while the wire is shorter than a coil.
double first_peak(const NozzleOptions& nozzle) {
  Scenario scenario = with_nozzle(nozzle);
  scenario.insertion.increment = 0.5;
  QuasistaticPacking packing(scenario);
  double peak = 0;
  while (packing.progress().last.inserted_length < 50 && !packing.advance().stop) {
    peak = std::max(peak, packing.progress().last.force);
  }
  return peak;
}

TEST(Nozzle, the_buckling_load_of_a_sphere_is_the_same_from_everywhere) {
  const double from_pole = first_peak({});
  EXPECT_GT(from_pole, 0);
  const Vec3 elsewhere = 19 * Vec3(1, -2, 0.5).normalized();
  EXPECT_NEAR(first_peak({.position = elsewhere}), from_pole, 0.02 * from_pole);
}

}  // namespace
}  // namespace wirepack
