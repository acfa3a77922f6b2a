#include "wirepack/packing/imperfection.hpp"

#include <gtest/gtest.h>

namespace wirepack {
namespace {

Scenario imperfect(std::uint64_t seed) {
  Scenario scenario = default_scenario(Setup::high_torsion, {10});
  scenario.seed = seed;
  scenario.imperfection = {0.2, 1.5, 0.1};
  return scenario;
}

TEST(Imperfection, AmplitudesOfZeroLeaveWireAndNozzleAsTheyAre) {
  Scenario scenario = imperfect(1);
  scenario.imperfection = {};
  const DrawnSetup drawn = drawn_setup(scenario);
  EXPECT_EQ(drawn.wire.rest_darboux, scenario.wire.rest_darboux);
  EXPECT_EQ(drawn.nozzle.position, Vec3(0, 0, 9));
  EXPECT_EQ(drawn.nozzle.direction, Vec3::UnitZ());
}

TEST(Imperfection, SeedsDrawDifferentSetupsWithinTheAmplitudes) {
  double largest_curvature = 0, largest_offset = 0, largest_tilt = 0;
  Vec3 mean = Vec3::Zero();
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Scenario scenario = imperfect(seed);
    const DrawnSetup drawn = drawn_setup(scenario);
    const Vec3 curvature = drawn.wire.rest_darboux - scenario.wire.rest_darboux;
    EXPECT_EQ(curvature.z(), 0);
    EXPECT_NEAR(drawn.nozzle.position.norm(), 9, 1e-12);  // still at the wall
    EXPECT_NEAR(drawn.nozzle.direction.norm(), 1, 1e-12);
    mean += drawn.nozzle.direction / 400;
    largest_curvature = std::max(largest_curvature, curvature.norm());
    largest_offset = std::max(largest_offset, 9 * std::acos(drawn.nozzle.position.z() / 9));
    largest_tilt = std::max(largest_tilt, std::acos(drawn.nozzle.direction.z()));
  }
  // the largest of 400 uniform numbers is above 0.97 of their bound but for exp(-12)
  EXPECT_LE(largest_curvature, 0.02);
  EXPECT_GT(largest_curvature, 0.97 * 0.02);
  EXPECT_LE(largest_offset, 1.5);
  EXPECT_GT(largest_offset, 0.97 * 1.5);
  EXPECT_LE(largest_tilt, 0.1);
  EXPECT_GT(largest_tilt, 0.97 * 0.1);
  EXPECT_LT(mean.head<2>().norm(), 0.01);  // no direction is favoured: 0.04 / sqrt(400) each
}

TEST(Imperfection, ASeedDrawsTheSameOffsetWhateverTheOtherAmplitudes) {
  Scenario scenario = imperfect(3);
  const DrawnSetup all = drawn_setup(scenario);
  scenario.imperfection = {0, 1.5, 0};
  EXPECT_EQ(drawn_setup(scenario).nozzle.position, all.nozzle.position);
}

}  // namespace
}  // namespace wirepack
