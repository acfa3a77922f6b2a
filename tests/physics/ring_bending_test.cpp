#include <gtest/gtest.h>

#include "../support/bent_ring.hpp"
#include "../support/strands.hpp"

namespace wirepack {
namespace {

using testing::bent_by_tip_moment;
using testing::unit_rod;

// Angle of a joint of length l under the moment M. Its energy is
// YI (8 sin^2(phi / 2) + 4 tan^2(phi / 2)) / (6 l), so that, with t = tan(phi / 2),
// M = dE/dphi = 2/3 YI / l (sin(phi) + t (1 + t^2)).
double joint_angle(double moment_by_bend, double length) {
  double angle = moment_by_bend * length;
  for (int i = 0; i < 50; ++i) {
    const double t = std::tan(angle / 2), grown = 1 + t * t;
    const double excess = 2.0 / 3 * (std::sin(angle) + t * grown) - moment_by_bend * length;
    angle -= excess / (2.0 / 3 * (std::cos(angle) + grown * (grown + 2 * t * t) / 2));
  }
  return angle;
}

Vec3 tip_of_exact_polygon(Index edges, double moment_by_bend, double edge_length) {
  double angle = joint_angle(moment_by_bend, edge_length / 2);
  Vec3 tip = Vec3::Zero();
  for (Index j = 0; j < edges; ++j) {
    tip += edge_length * Vec3(0, -std::sin(angle), std::cos(angle));
    angle += joint_angle(moment_by_bend, edge_length);
  }
  return tip;
}

TEST(RingBending, TipMomentBendsTheRodIntoTheRegularPolygonOfItsStrain) {
  for (const Index edges : {6, 40}) {
    const RodParams params = unit_rod(edges, 1, 4e4);
    for (const double moment : {1.0, 2 * pi, -2 * pi}) {
      const RodState state = bent_by_tip_moment(params, edges, moment);
      const Vec3 expected = tip_of_exact_polygon(edges, moment, params.edge_length);
      // rest to 1e-7 YI / L^2 over the softest bending mode, about 10 YI / L^3
      EXPECT_LT((state.nodes.col(edges) - expected).norm(), 1e-7) << edges << " " << moment;
    }
  }
}

// MuJoCo test/plugin/elasticity/cable_test.cc, CantileverIntoCircle: 41 points, radius 0.005, bend
// modulus 1e9; there the turning angle is the strain and the ring closes exactly, here to order 4.
TEST(RingBending, CantileverIntoCircleOfMujocoClosesToFourthOrder) {
  RodParams params;
  params.radius = 0.005;
  params.youngs_modulus = 1e9;
  params.edge_length = 1.0 / 40;
  const double moment = 2 * pi * stiffness(params).bend;
  EXPECT_NEAR(moment, 3.08425, 1e-5);  // printed digits
  const RodState state = bent_by_tip_moment(params, 40, moment);
  // with x = M l / YI a joint turns by x (1 - 7/240 x^4): the ring stays open by the
  // angle 2 pi 7/240 (2 pi / N)^4, which moves the tip by that times L / (2 pi)
  const double gap = 7.0 / 240 * std::pow(2 * pi / 40, 4);
  EXPECT_NEAR(state.nodes.col(40).norm(), gap, 0.1 * gap);
}

// E = YI (2 pi / L)^2 L / 2, so a longer ring costs less.
TEST(RingBending, a_closed_ring_that_grows_gives_its_bending_energy_back) {
  constexpr Index edges = 100;
  RodParams params;
  params.stretch_multiplier = 1000;
  RodState ring =
      make_rod(testing::ring_nodes(edges / (2 * pi), edges), params, RodEnds{.closed = true});
  const StretchEnergy stretch(params);
  const JointEnergy joints(params);
  const double bend = stiffness(params).bend;
  const double energy = 2 * pi * pi * bend / edges, force = -energy / edges;
  const EquilibriumReport found =
      solve_equilibrium(ring, HeldUnknowns::none(ring), {stretch, joints},
                        equilibrium_options(bend, edges, 1e-5 * std::abs(force)));
  ASSERT_EQ(found.end, EquilibriumEnd::converged);
  const double second_order = std::pow(2 * pi / edges, 2);
  EXPECT_NEAR(found.energy, energy, second_order * energy);
  EXPECT_NEAR(found.inlet_length_force, force, second_order * std::abs(force));
}

}  // namespace
}  // namespace wirepack
