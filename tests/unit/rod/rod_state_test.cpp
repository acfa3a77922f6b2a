#include "wirepack/rod/rod_state.hpp"

#include <gtest/gtest.h>

#include "wirepack/core/error.hpp"
#include "wirepack/core/rotation.hpp"
#include "wirepack/rod/rod_strain.hpp"

#include "../../support/sample_rods.hpp"

namespace wirepack {
namespace {

using testing::random_rod;
using testing::straight_nodes;

std::string message_of(const RodState& state) {
  try {
    check_state(state);
  } catch (const NumericalFailure& failure) {
    return failure.what();
  }
  return {};
}

TEST(RodState, MadeFromNodesIsAdaptedAndUntwisted) {
  const RodParams params;
  for (const RodEnds& ends : {RodEnds{}, RodEnds{.first_clamped = true, .last_clamped = true}}) {
    const RodState state = make_rod(random_rod(20, params, ends, 3).nodes, params, ends);
    EXPECT_EQ(message_of(state), "");
    for (const double twist : joint_twists(state)) EXPECT_NEAR(twist, 0, 1e-14);
    EXPECT_EQ(state.frames.size(), ends.first_clamped ? 21U : 19U);
  }
}

TEST(RodState, NodeLengthsSumToTheRestLengthAndGrowWithTheInlet) {
  RodParams params;
  params.edge_length = 0.7;
  RodState state = make_rod(straight_nodes(5, 3.5), params);
  state.inlet_rest_length = 0.3;
  double sum = 0, growth = 0;
  for (Index i = 0; i < state.node_count(); ++i) {
    sum += node_length(state, params, i);
    growth += node_length_by_inlet(state, i);
  }
  EXPECT_NEAR(sum, 4 * 0.7 + 0.3, 1e-14);
  EXPECT_NEAR(total_rest_length(state, params), sum, 1e-14);
  EXPECT_NEAR(node_length(state, params, 0), 0.35, 1e-15);
  EXPECT_NEAR(node_length(state, params, 4), 0.5, 1e-15);
  EXPECT_EQ(growth, 1);
}

TEST(RodState, ClosedRodHasAnEdgeAndAJointMore) {
  const RodParams params;
  Points square(3, 4);
  square << 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0;
  const RodState state = make_rod(square, params, {.closed = true});
  EXPECT_EQ(state.edge_count(), 4);
  EXPECT_EQ(total_rest_length(state, params), 4);
  std::vector<Index> nodes;
  for_each_joint(state, [&](const Joint& joint) { nodes.push_back(joint.node); });
  EXPECT_EQ(nodes, (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(node_length(state, params, 0), 1);
}

TEST(RodState, RemovingTwistKeepsTheFrameAtTheNozzleAndTheNodes) {
  const RodParams params;
  RodState state = random_rod(15, params, {.first_clamped = true, .last_clamped = true}, 19);
  const RodState before = state;
  double twist = 0;
  for (const double t : joint_twists(state)) twist += std::abs(t);
  EXPECT_GT(twist, 0.5);
  remove_twist(state);
  for (const double t : joint_twists(state)) EXPECT_NEAR(t, 0, 1e-14);
  EXPECT_EQ((state.nodes - before.nodes).norm(), 0);
  const auto last = static_cast<std::size_t>(state.last_clamp_frame());
  EXPECT_EQ((state.frames[last].coeffs() - before.frames[last].coeffs()).norm(), 0);
  EXPECT_EQ(message_of(state), "");
}

TEST(RodState, CoincidentNodesAndATurnBackAreNumericalFailuresThatNameTheirPlace) {
  const RodParams params;
  Points nodes = straight_nodes(4, 4);
  nodes.col(3) = nodes.col(2);
  EXPECT_THROW(
      {
        try {
          make_rod(nodes, params);
        } catch (const NumericalFailure& failure) {
          EXPECT_STREQ(failure.what(), "edge 2 has no length");
          throw;
        }
      },
      NumericalFailure);
  nodes.col(3) = nodes.col(1);
  EXPECT_THROW(make_rod(nodes, params), NumericalFailure);
}

TEST(RodState, CheckNamesTheFrameThatHasLeftItsEdge) {
  const RodParams params;
  RodState state = random_rod(8, params, {}, 23);
  state.frames[4] = rotation_about(Vec3::UnitX(), 1e-6) * state.frames[4];
  EXPECT_NE(message_of(state).find("edge 4"), std::string::npos) << message_of(state);
  state = random_rod(8, params, {}, 23);
  state.nodes(1, 3) = std::nan("");
  EXPECT_NE(message_of(state).find("not finite"), std::string::npos) << message_of(state);
}

}  // namespace
}  // namespace wirepack
