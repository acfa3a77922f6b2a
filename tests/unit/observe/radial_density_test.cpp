#include "wirepack/observe/radial_density.hpp"

#include <gtest/gtest.h>
#include <numeric>

#include "../../support/strands.hpp"

namespace wirepack {
namespace {

RodState closed_ring(double radius, Index edges) {
  return make_rod(testing::ring_nodes(radius, edges), RodParams{}, {.closed = true});
}

// Volume of a torus within a ball about its middle: the part of its disc inside a circle, each
// strip of it turned around the axis. Strips of sqrt(2 / 3) digits: midpoints at half-circle
// densities.
double torus_within(double ring, double radius, double ball) {
  const int strips = 400000;
  double volume = 0;
  for (int k = 0; k < strips; ++k) {
    // x = ring - radius cos(u)
    const double u = pi * (k + 0.5) / strips, x = ring - radius * std::cos(u);
    const double inside = std::max(0.0, ball * ball - x * x);
    const double half = std::min(radius * std::sin(u), std::sqrt(inside));
    volume += 2 * pi * x * 2 * half * radius * std::sin(u) * pi / strips;
  }
  return volume;
}

TEST(RadialDensity, of_a_ring_is_that_of_the_torus_cut_by_balls) {
  const double ring = 10, radius = 1, whole = 2 * pi * pi * ring;
  const std::vector<double> balls{8, 9.2, 9.9, 10, 10.3, 10.95, 11.2};
  const std::vector<double> found = volume_within(closed_ring(ring, 120), radius, balls);
  const std::vector<double> finer = volume_within(closed_ring(ring, 240), radius, balls);
  for (std::size_t k = 0; k < balls.size(); ++k) {
    const double exact = torus_within(ring, radius, balls[k]);
    // edges of a/2 are chords, (l / r)^2 / 24 of the radius nearer to the middle on average
    EXPECT_NEAR(found[k], exact, 1.6e-3 * whole) << balls[k];
    EXPECT_NEAR(finer[k], exact, 4e-4 * whole) << balls[k];  // order two
  }
  EXPECT_EQ(found.front(), 0);
  EXPECT_NEAR(finer.back(), whole, 2e-4 * whole);
}

TEST(RadialDensity, of_a_straight_wire_through_the_centre_is_exact) {
  // a cylinder in a ball is a shorter cylinder and two caps
  const Points nodes = testing::centred_strand(Vec3::Zero(), Vec3::UnitZ(), 0.05, 400);
  const RodState state = make_rod(nodes, RodParams{});
  const double ball = 5, radius = 1, height = std::sqrt(ball * ball - radius * radius);
  const double cap = ball - height, cap_volume = pi * cap * cap * (3 * ball - cap) / 3;
  const double exact = 2 * pi * height * radius * radius + 2 * cap_volume;
  EXPECT_NEAR(volume_within(state, radius, {ball})[0], exact, 1e-4 * exact);
}

TEST(RadialDensity, of_shells_sums_to_the_volume_of_the_wire) {
  const double ring = 6, cavity = 8;
  double volume = 0;
  for (const ShellDensity& shell : radial_density(closed_ring(ring, 100), 1, cavity, 37)) {
    volume += shell.density * 4 * pi / 3 * (std::pow(shell.outer, 3) - std::pow(shell.inner, 3));
  }
  EXPECT_NEAR(volume, 2 * pi * pi * ring, 1e-3 * volume);  // the polygon is shorter than the ring
}

}  // namespace
}  // namespace wirepack
