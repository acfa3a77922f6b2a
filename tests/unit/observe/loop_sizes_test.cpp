#include "wirepack/observe/loop_sizes.hpp"

#include <gtest/gtest.h>

#include "../../support/strands.hpp"

namespace wirepack {
namespace {

TEST(LoopSizes, of_a_helix_are_the_length_of_a_turn_of_its_tangent) {
  const double radius = 5, pitch = 4, turns = 3.4;
  const RodState state = make_rod(testing::helix_strand(radius, pitch, turns, 2000), RodParams{});
  const double rise = pitch / (2 * pi), curvature = radius / (radius * radius + rise * rise);
  for (const double found : local_curvatures(state))
    EXPECT_NEAR(found, curvature, 1e-4 * curvature);
  const std::vector<double> loops = loop_lengths(state);
  ASSERT_EQ(loops.size(), 3U);  // 3.37 of them
  for (const double loop : loops) EXPECT_NEAR(loop, 2 * pi / curvature, 1e-3 * loop);
}

TEST(LoopSizes, the_curvature_of_a_polygon_is_one_over_the_radius_of_its_circle) {
  Points nodes(3, 7);
  const double radius = 4, turn = 0.5;
  for (Index i = 0; i < 7; ++i) {
    const double angle = turn * static_cast<double>(i);
    nodes.col(i) = radius * Vec3(std::cos(angle), std::sin(angle), 0);
  }
  for (const double found : local_curvatures(make_rod(nodes, RodParams{})))
    EXPECT_NEAR(found * radius, 1 + turn * turn / 24, 1e-3);
}

TEST(LoopSizes, of_a_straight_wire_are_none) {
  const RodState state =
      make_rod(testing::centred_strand(Vec3::Zero(), Vec3::UnitX(), 1, 50), RodParams{});
  EXPECT_TRUE(loop_lengths(state).empty());
  for (const double found : local_curvatures(state)) EXPECT_LT(found, 1e-7);
}

}  // namespace
}  // namespace wirepack
