#include "wirepack/observe/shell_order.hpp"

#include <gtest/gtest.h>

#include "../../support/strands.hpp"

namespace wirepack {
namespace {

TEST(ShellOrder, sees_a_ring_at_the_wall_as_a_quarter_and_a_straight_core_as_one) {
  Points nodes(3, 160);
  nodes.leftCols(120) = testing::ring_nodes(9.9, 120);
  nodes.rightCols(40) = testing::centred_strand(Vec3::Zero(), Vec3::UnitZ(), 0.1, 39);
  RodState state;
  state.nodes = nodes;
  const std::vector<ShellOrder> shells = order_by_shell(state, Cavity{10}, 2.5);
  ASSERT_EQ(shells.size(), 4U);
  EXPECT_EQ(shells[0].outer, 10);
  EXPECT_EQ(shells[3].inner, 0);
  EXPECT_NEAR(shells[0].order, 0.25, 0.01);  // the last of 120 edges is missing
  EXPECT_EQ(shells[2].order, 0);
  EXPECT_EQ(shells[2].edges, 0);
  EXPECT_NEAR(shells[3].order, 1, 1e-12);
  EXPECT_EQ(shells[3].edges, 39);
}

}  // namespace
}  // namespace wirepack
