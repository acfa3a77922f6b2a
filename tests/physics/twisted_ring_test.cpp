#include <gtest/gtest.h>

#include "wirepack/rod/rod_strain.hpp"

#include "../support/twisted_rods.hpp"

namespace wirepack {
namespace {

using testing::critical_turns;
using testing::solver_rest;
using testing::twisted_ring;
using testing::TwistedRing;

TEST(TwistedRing, BucklesAtMichellsTwistForAllPoissonRatios) {
  for (const double poisson_ratio : {0.0, 0.25, 0.3, 1.0 / 3, 0.5}) {
    const double exact = std::sqrt(3.0) * (1 + poisson_ratio);
    // bending is too stiff by (2 pi / N)^2 / 3 and the mode of two waves by four times 1 / 12: 3e-3
    EXPECT_NEAR(critical_turns(100, poisson_ratio) / exact, 1, 4e-3) << poisson_ratio;
  }
}

TEST(TwistedRing, IsAtRestFlatWithUniformTwist) {
  const TwistedRing ring = twisted_ring(50, 0.3, 1.7);
  const testing::Reactions out_of_balance = testing::reactions(ring.state, ring.params);
  // moments of 8 YI / L act on every joint, forces of their size over l = 0.02 cancel
  EXPECT_LT(out_of_balance.force.cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT(out_of_balance.moment.cwiseAbs().maxCoeff(), 1e-10);
  const double twist = 2 * pi * 1.7;
  EXPECT_NEAR(joint_energies(ring.params, ring.state).twist, twist * twist / 1.3 / 2, 1e-9);
}

double height(const RodState& state) {
  const Points centred = state.nodes.colwise() - state.nodes.rowwise().mean();
  const Eigen::SelfAdjointEigenSolver<Mat3> inertia(centred * centred.transpose());
  return (inertia.eigenvectors().col(0).transpose() * centred).cwiseAbs().maxCoeff();
}

// Of the flat ring of length and YI one.
double exact_energy(double turns, double poisson_ratio) {
  return 2 * pi * pi + std::pow(2 * pi * turns, 2) / (2 * (1 + poisson_ratio));
}

void disturb(RodState& state) {
  Random random(41);
  for (Index i = 0; i < state.node_count(); ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(state.node_count());
    state.nodes(2, i) += 1e-3 * std::cos(2 * angle) + 1e-4 * random.symmetric();
  }
  for (Index j = 0; j < state.edge_count(); ++j) {
    Quat& frame = state.frames[static_cast<std::size_t>(j)];
    frame = transport(third_axis(frame), testing::tangent(state, j)) * frame;
  }
}

TwistedRing after_disturbance(Index edges, double poisson_ratio, double turns) {
  TwistedRing ring = twisted_ring(edges, poisson_ratio, turns);
  EXPECT_NEAR(testing::elastic_energy(ring.state, ring.params), exact_energy(turns, poisson_ratio),
              0.04);
  disturb(ring.state);
  solver_rest(ring.state, testing::ring_supports(ring.state), ring.params, {}, {1e-4, 1e-4});
  return ring;
}

// A ring that buckles folds into a figure of eight, which, without contact, passes through itself
// and comes out as a flat ring with two turns less (White: the link jumps by two).
TEST(TwistedRing, ADisturbanceDecaysBelowMichellsTwistAndGrowsAbove) {
  constexpr double poisson_ratio = 0.3;
  const double critical = std::sqrt(3.0) * (1 + poisson_ratio);
  const TwistedRing below = after_disturbance(60, poisson_ratio, 0.97 * critical);
  EXPECT_LT(height(below.state), 1e-5);  // a hundredth of the disturbance
  // the polygon of 60 is too stiff by (2 pi / N)^2 / 6 of 20
  EXPECT_NEAR(testing::elastic_energy(below.state, below.params),
              exact_energy(0.97 * critical, poisson_ratio), 0.04);
  const TwistedRing above = after_disturbance(60, poisson_ratio, 1.03 * critical);
  EXPECT_NEAR(testing::elastic_energy(above.state, above.params),
              exact_energy(1.03 * critical - 2, poisson_ratio), 0.04);
}

// The same with real turns: two whole turns of a closed ring, sqrt 3 (1 + nu) being below or above.
TEST(TwistedRing, OfLinkTwoBucklesOnlyIfItsTwistIsStiffEnough) {
  for (const double poisson_ratio : {0.10, 0.21}) {  // critical turns 1.905 and 2.096
    const RodParams params = testing::unit_rod(60, 1, 4e4, poisson_ratio);
    RodState state = make_rod(testing::ring_nodes(60), params, {.closed = true});
    testing::twist_uniformly(state, 2 * (2 * pi));
    EXPECT_NEAR(testing::elastic_energy(state, params), exact_energy(2, poisson_ratio), 0.04);
    disturb(state);
    solver_rest(state, testing::ring_supports(state), params, {}, {1e-4, 1e-4});
    const double turns_left = poisson_ratio < 0.15 ? 0 : 2;
    EXPECT_NEAR(testing::elastic_energy(state, params), exact_energy(turns_left, poisson_ratio),
                0.04);
  }
}

}  // namespace
}  // namespace wirepack
