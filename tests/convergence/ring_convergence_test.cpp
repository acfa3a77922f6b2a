#include <gtest/gtest.h>

#include "../support/bent_ring.hpp"
#include "../support/measured_order.hpp"
#include "../support/twisted_rods.hpp"

namespace wirepack {
namespace {

using testing::refine;
using testing::Refinement;

// Errors at N = 200 in the comments of all these are (2 pi / N)^2 = 1e-3 times a fraction.
TEST(RingConvergence, BendEnergyOfARingIsOfOrderTwo) {
  const Refinement r = refine([](Index edges) {
    const RodParams params = testing::unit_rod(edges);
    const RodState ring = make_rod(testing::ring_nodes(edges), params, {.closed = true});
    return std::abs(joint_energies(params, ring).bend / (2 * pi * pi) - 1);
  });
  EXPECT_GT(r.order, 1.98);
  EXPECT_NEAR(r.errors.back(), std::pow(2 * pi / 200, 2) / 6, 1e-6);  // (2 tan(x / 2) / x)^2 - 1
}

TEST(RingConvergence, TipMomentClosesTheRodIntoARingWithOrderTwo) {
  const Refinement r = refine([](Index edges) {
    const RodState state =
        testing::bent_by_tip_moment(testing::unit_rod(edges, 1, 4e4), edges, 2 * pi);
    return state.nodes.col(edges).norm();
  });
  EXPECT_GT(r.order, 1.9);
  EXPECT_NEAR(r.errors.back(), std::pow(2 * pi / 200, 2) / 3, 1e-5);  // angle left open over 2 pi
}

TEST(RingConvergence, MichellsCriticalTwistIsOfOrderTwo) {
  const Refinement r = refine(
      [](Index edges) { return std::abs(testing::critical_turns(edges, 0.3) / 2.251666 - 1); });
  EXPECT_GT(r.order, 1.9);
  EXPECT_LT(r.errors.back(), std::pow(2 * pi / 200, 2));
}

}  // namespace
}  // namespace wirepack
