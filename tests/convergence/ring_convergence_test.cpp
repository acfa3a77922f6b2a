#include <gtest/gtest.h>

#include "../support/bent_ring.hpp"
#include "../support/measured_order.hpp"
#include "../support/twisted_rods.hpp"

namespace wirepack {
namespace {

using testing::refine;
using testing::Refinement;

// A joint of the ring turns by x = 2 pi / N. The square of its strain is too large by 7/720 x^4,
// and the moment by three times that.
TEST(RingConvergence, BendEnergyOfARingIsOfOrderFour) {
  const Refinement r = refine([](Index edges) {
    const RodParams params = testing::unit_rod(edges);
    const RodState ring = make_rod(testing::ring_nodes(edges), params, {.closed = true});
    return std::abs(joint_energies(params, ring).bend / (2 * pi * pi) - 1);
  });
  EXPECT_GT(r.order, 3.98);
  const double exact = 7.0 / 720 * std::pow(2 * pi / 200, 4);
  EXPECT_NEAR(r.errors.back(), exact, 1e-3 * exact);
}

TEST(RingConvergence, TipMomentClosesTheRodIntoARingWithOrderFour) {
  const std::vector<Index> counts{10, 20, 40};
  std::vector<double> errors;
  for (const Index edges : counts) {
    const RodState state =
        testing::bent_by_tip_moment(testing::unit_rod(edges, 1, 4e4), edges, 2 * pi);
    errors.push_back(state.nodes.col(edges).norm());
  }
  EXPECT_GT(testing::measured_order(counts, errors), 3.9);
  const double exact = 7.0 / 240 * std::pow(2 * pi / 40, 4);  // angle left open over 2 pi
  EXPECT_NEAR(errors.back(), exact, 0.05 * exact);
}

TEST(RingConvergence, MichellsCriticalTwistIsOfOrderTwo) {
  const Refinement r = refine(
      [](Index edges) { return std::abs(testing::critical_turns(edges, 0.3) / 2.251666 - 1); });
  EXPECT_GT(r.order, 1.9);
  EXPECT_LT(r.errors.back(), std::pow(2 * pi / 200, 2));
}

}  // namespace
}  // namespace wirepack
