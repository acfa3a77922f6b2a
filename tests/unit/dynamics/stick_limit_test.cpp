#include "wirepack/dynamics/stick_limit.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/core/error.hpp"

#include "../../support/moving_wire.hpp"

namespace wirepack {
namespace {

TEST(StickLimit, the_measured_limits_are_met) {
  EXPECT_DOUBLE_EQ(largest_stick_step(0), 0.64);
  EXPECT_DOUBLE_EQ(largest_stick_step(0.5), 0.16);
  EXPECT_DOUBLE_EQ(largest_stick_step(2), 0.04);
}

TEST(StickLimit, the_longest_step_is_the_limit_over_the_frequency) {
  // frequency 3, damping ratio 1/2
  EXPECT_DOUBLE_EQ(longest_stick_step({0.2, 0.18, 0.5, 1.0 / 3}, 18), 0.16 / 3);
}

TEST(StickLimit, a_long_relaxation_time_needs_a_short_step) {
  // frequency 1, damping ratio 2
  const StickSlipLaw law{0.2, 0.18, 0.5, 4};
  EXPECT_NO_THROW(require_calm_sticking(law, 2, 0.04));
  EXPECT_THROW(require_calm_sticking(law, 2, 0.041), InvalidInput);
  const StickSlipLaw hardly_damped{0.2, 0.18, 0.5, 0.1};
  EXPECT_NO_THROW(require_calm_sticking(hardly_damped, 2, 0.2));
}

TEST(StickLimit, a_wire_on_a_wall_refuses_a_law_that_chatters) {
  WireForces forces;
  forces.cavity = Cavity{10};
  Points nodes = Points::Zero(3, 4);
  nodes.row(0) << -1, 0, 1, 2;
  nodes.row(2).setConstant(-9);
  const RodState rod = make_rod(nodes, forces.wire);
  const HeldUnknowns held = HeldUnknowns::none(rod);
  forces.friction = testing::paper_friction();
  testing::MovingWire calm(forces, 1, held, rod, 0.05);
  EXPECT_NO_THROW(calm.advance(1));
  forces.friction->relaxation_time = 10;
  testing::MovingWire chattering(forces, 1, held, rod, 0.05);
  EXPECT_THROW(chattering.advance(1), InvalidInput);
}

}  // namespace
}  // namespace wirepack
