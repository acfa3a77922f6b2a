#include "wirepack/energy/stretch_energy.hpp"

#include <gtest/gtest.h>

#include "../../support/sample_rods.hpp"

namespace wirepack {
namespace {

// Energy of one straight edge over EA and its rest length, and the force that presses it over EA.
struct Pressed {
  double energy, force;
};

Pressed pressed_to(double ratio) {
  RodParams params;
  params.edge_length = 3;
  const double stiff = stiffness(params).stretch;
  const RodState state = make_rod(testing::straight_nodes(1, ratio * params.edge_length), params);
  Gradient gradient;
  set_zero(gradient, state);
  const double energy = double(StretchEnergy(params).add_gradient(state, gradient));
  return {energy / (stiff * params.edge_length), -gradient.node(2, 1) / stiff};
}

TEST(StretchEnergy, is_that_of_a_linear_spring_down_to_half_the_length) {
  for (const double ratio : {1.5, 1.0, 0.75, 0.5}) {
    EXPECT_NEAR(pressed_to(ratio).energy, (ratio - 1) * (ratio - 1) / 2, 1e-14);
    EXPECT_NEAR(pressed_to(ratio).force, 1 - ratio, 1e-14);
  }
}

TEST(StretchEnergy, keeps_an_edge_from_collapsing_under_any_force) {
  // (1/2 - x)^3 / x and its slope at x = 1/4 are 1/16 and -1
  EXPECT_NEAR(pressed_to(0.25).energy, 9.0 / 32 + 1.0 / 16, 1e-14);
  EXPECT_NEAR(pressed_to(0.25).force, 0.75 + 1, 1e-14);
  EXPECT_GT(pressed_to(1e-4).force, 1e6);
  EXPECT_GT(pressed_to(1e-4).energy, 1e3);
}

}  // namespace
}  // namespace wirepack
