#include <gtest/gtest.h>

#include "wirepack/rod/rod_strain.hpp"

#include "../support/elastic_rest.hpp"
#include "../support/sample_rods.hpp"

namespace wirepack {
namespace {

using testing::hold_angle;
using testing::rest;
using testing::straight_nodes;

// Y = 5, a = 0.3, nu = 0.25: no constant is 1, so none can be forgotten.
RodParams thick_params(Index edges, double length) {
  RodParams params;
  params.radius = 0.3;
  params.poisson_ratio = 0.25;
  params.edge_length = length / static_cast<double>(edges);
  return params;
}

TEST(PureTension, ExtendsEveryEdgeByForceOverStretchStiffness) {
  constexpr double length = 4;
  for (const Index edges : {1, 7, 40}) {
    const RodParams params = thick_params(edges, length);
    const double stretch = 5 * pi * 0.3 * 0.3;  // Y pi a^2
    for (const double force : {0.01, 0.2}) {
      RodState state = make_rod(straight_nodes(edges, length), params);
      HeldUnknowns held = HeldUnknowns::none(state);
      held.hold_node(0);
      hold_angle(held, 0);
      Loads loads;
      loads.forces.push_back({edges, Vec3(0, 0, force)});
      rest(state, held, params, loads, {1e-11, 1e-11});
      for (Index j = 0; j < edges; ++j) {
        EXPECT_NEAR(edge_strain(state, params, j), force / stretch, 1e-9);  // tolerance over YA
      }
      EXPECT_NEAR(testing::elastic_energy(state, params), force * force * length / (2 * stretch),
                  1e-9);
    }
  }
}

TEST(PureTension, StretchMultiplierStiffensStretchAlone) {
  RodParams params = thick_params(5, 2);
  const Stiffness soft = stiffness(params);
  params.stretch_multiplier = 8;
  const Stiffness stiff = stiffness(params);
  EXPECT_DOUBLE_EQ(stiff.stretch, 8 * soft.stretch);
  EXPECT_DOUBLE_EQ(stiff.bend, soft.bend);
  EXPECT_DOUBLE_EQ(stiff.twist, soft.twist);
}

// A rod in a thin straight tube, so that it stays straight at any twist.
struct TwistedRod {
  RodParams params;
  RodState state;
  HeldUnknowns held;
};

TwistedRod twisted_rod(Index edges, double length) {
  TwistedRod rod{thick_params(edges, length), {}, {}};
  rod.state = make_rod(straight_nodes(edges, length), rod.params,
                       {.first_clamped = true, .last_clamped = true});
  rod.held = HeldUnknowns::none(rod.state);
  testing::hold_coordinate(rod.held, 0);
  testing::hold_coordinate(rod.held, 1);
  rod.held.hold_node(0);
  hold_angle(rod.held, rod.state.first_clamp_frame());
  hold_angle(rod.held, rod.state.last_clamp_frame());
  return rod;
}

void turn_last_clamp(RodState& state, double angle) {
  Quat& clamp = state.frames[static_cast<std::size_t>(state.last_clamp_frame())];
  clamp = rotation_about(Vec3::UnitZ(), angle) * clamp;
  state.twist_guide.back() += angle;
}

void expect_uniform_twist(const TwistedRod& rod, double turn, double length) {
  // G J with G = Y / (2 (1 + nu)) and J = pi a^4 / 2
  const double twist_stiffness = 5 / (2 * 1.25) * pi * std::pow(0.3, 4) / 2;
  const Vec3 moment =
      testing::reactions(rod.state, rod.params).moment.col(rod.state.last_clamp_frame());
  const double expected = twist_stiffness * turn / length;
  // rest to 1e-11, over a twist stiffness per node down to 0.03
  EXPECT_NEAR(moment.z(), expected, 1e-9 * std::abs(expected)) << turn;
  EXPECT_NEAR(moment.head<2>().norm(), 0, 1e-12);
  const JointEnergies energy = joint_energies(rod.params, rod.state);
  EXPECT_NEAR(energy.twist, expected * turn / 2, 1e-9 * std::abs(expected * turn)) << turn;
  EXPECT_NEAR(energy.bend, 0, 1e-14);
}

TEST(PureTorsion, MomentIsTwistStiffnessTimesTurnPerLengthForAnyTurnAndMesh) {
  constexpr double length = 4;
  for (const Index edges : {1, 3, 17, 60}) {
    for (const double turn : {0.1, -0.1, pi - 1e-3, pi + 1e-3, -pi - 1e-3, 2 * pi - 1e-3,
                              2 * pi + 1e-3, 4 * pi, 10 * 2 * pi, -10 * 2 * pi}) {
      TwistedRod rod = twisted_rod(edges, length);
      turn_last_clamp(rod.state, turn);
      rest(rod.state, rod.held, rod.params, {}, {1e-11, 1e-11});
      expect_uniform_twist(rod, turn, length);
    }
  }
}

TEST(PureTorsion, TenTurnsBuiltUpInStepsDoNotWrap) {
  constexpr double length = 4;
  TwistedRod rod = twisted_rod(3, length);
  for (int step = 0; step < 40; ++step) {
    Quat& clamp = rod.state.frames[static_cast<std::size_t>(rod.state.last_clamp_frame())];
    clamp = rotation_about(Vec3::UnitZ(), pi / 2) * clamp;  // the guide is left to the solver
    rest(rod.state, rod.held, rod.params, {}, {1e-11, 1e-11});
  }
  expect_uniform_twist(rod, 20 * pi, length);
}

TEST(PureTorsion, AFreeEndTurnsAlongWithoutTwist) {
  TwistedRod rod = twisted_rod(12, 4);
  rod.held.angle[static_cast<std::size_t>(rod.state.last_clamp_frame())] = false;
  Quat& first = rod.state.frames[static_cast<std::size_t>(rod.state.first_clamp_frame())];
  first = rotation_about(Vec3::UnitZ(), 1.2) * first;
  const double before = joint_energies(rod.params, rod.state).twist;
  rest(rod.state, rod.held, rod.params, {}, {1e-11, 1e-11});
  EXPECT_GT(before, 1e-3);
  EXPECT_NEAR(joint_energies(rod.params, rod.state).twist, 0, 1e-16);  // squares of 1e-9
}

}  // namespace
}  // namespace wirepack
