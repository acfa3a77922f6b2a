#include <gtest/gtest.h>

#include "../support/elastic_rest.hpp"
#include "../support/sample_rods.hpp"

namespace wirepack {
namespace {

using testing::rest;
using testing::straight_nodes;

RodParams curved_params(Index edges, double length) {
  RodParams params;
  params.radius = 0.3;
  params.youngs_modulus = 7;
  params.edge_length = length / static_cast<double>(edges);
  params.rest_darboux = Vec3(0.4, 0, 0);
  return params;
}

TEST(NaturalCurvature, HeldStraightStoresHalfTheBendStiffnessTimesItsSquare) {
  constexpr double length = 3;
  for (const Index edges : {1, 5, 50}) {
    const RodParams params = curved_params(edges, length);
    RodState state = make_rod(straight_nodes(edges, length), params,
                              {.first_clamped = true, .last_clamped = true});
    HeldUnknowns held = HeldUnknowns::none(state);
    held.hold_node(0);
    held.hold_node(edges);
    testing::hold_angle(held, state.first_clamp_frame());
    testing::hold_angle(held, state.last_clamp_frame());
    rest(state, held, params, {}, {1e-10, 1e-10});
    const double bend = 7 * pi * std::pow(0.3, 4) / 4;
    // exact for any mesh: no joint turns, and the half joints at the clamps make up the length
    EXPECT_NEAR(testing::elastic_energy(state, params), bend * 0.16 * length / 2, 1e-12);
    const testing::Reactions reaction = testing::reactions(state, params);
    EXPECT_NEAR(reaction.moment.col(state.last_clamp_frame()).norm(), bend * 0.4, 1e-12);
    EXPECT_NEAR(reaction.moment.col(state.first_clamp_frame()).norm(), bend * 0.4, 1e-12);
  }
}

// A ring of radius rho with d1 turned from the axis of the ring by `roll`.
double ring_energy(Index edges, double rho, double roll, RodParams params, bool relaxed) {
  const auto n = static_cast<double>(edges);
  params.edge_length = 2 * pi * rho / n;
  params.stretch_multiplier = 1000;
  const double polygon_radius = params.edge_length / (2 * std::sin(pi / n));
  Points nodes(3, edges);
  for (Index i = 0; i < edges; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / n;
    nodes.col(i) = polygon_radius * Vec3(std::cos(angle), std::sin(angle), 0);
  }
  RodState state = make_rod(nodes, params, {.closed = true});
  for (Index j = 0; j < edges; ++j) {
    const Vec3 t = testing::tangent(state, j);
    Mat3 axes;
    axes << Vec3::UnitZ(), t.cross(Vec3::UnitZ()), t;
    state.frames[static_cast<std::size_t>(j)] = rotation_about(t, roll) * Quat(axes);
  }
  if (relaxed) {
    HeldUnknowns held = HeldUnknowns::none(state);
    held.coordinate.assign(held.coordinate.size(), true);
    rest(state, held, params, {}, {1e-9, 1e-9});
  }
  return testing::elastic_energy(state, params);
}

TEST(NaturalCurvature, ForcedOntoARingStoresTheSquareOfTheDifferenceOrOfTheSum) {
  const RodParams params = curved_params(1, 1);
  const double bend = 7 * pi * std::pow(0.3, 4) / 4;
  for (const double rho : {1.0, 2.0, 5.0}) {
    const double length = 2 * pi * rho;
    const double with = bend * length / 2 * std::pow(1 / rho - 0.4, 2);
    const double against = bend * length / 2 * std::pow(1 / rho + 0.4, 2);
    // strain 2 pi / N but for 7/1440 of its fourth power: 8e-8 of 1 / rho at N = 100
    const double tolerance = 1e-7 * bend * length / rho * (1 / rho + 0.4);
    EXPECT_NEAR(ring_energy(100, rho, 0, params, false), with, tolerance);
    EXPECT_NEAR(ring_energy(100, rho, pi, params, false), against, tolerance);
  }
}

TEST(NaturalCurvature, ARingFreeToRollPutsItsCurvatureInside) {
  const RodParams params = curved_params(1, 1);
  const double bend = 7 * pi * std::pow(0.3, 4) / 4;
  const double with = bend * 2 * pi * 2 / 2 * std::pow(0.5 - 0.4, 2);
  const double found = ring_energy(60, 2, 2.5, params, true);
  EXPECT_GT(ring_energy(60, 2, 2.5, params, false), 10 * with);
  EXPECT_NEAR(found, with, 0.02 * with);  // 6e-7 of the curvature 0.5 against a difference of 0.1
}

}  // namespace
}  // namespace wirepack
