#include "wirepack/rod/frame_chart.hpp"

#include <gtest/gtest.h>

#include "wirepack/core/rotation.hpp"
#include "wirepack/rod/rod_strain.hpp"

#include "../../support/sample_rods.hpp"

namespace wirepack {
namespace {

using testing::random_rod;

TEST(FrameChart, FramesStayUnitAndOnTheirTangentsOverAHundredThousandReferences) {
  const RodParams params;
  const RodState start = random_rod(6, params, {.first_clamped = true, .last_clamped = true}, 13);
  RodState state = start;
  Random random(31);
  for (int step = 0; step < 100000; ++step) {
    const FrameChart chart(state, HeldUnknowns::none(state));
    Eigen::VectorXd x = FrameChart(start, HeldUnknowns::none(start)).unknowns();
    for (double& v : x) v += 0.1 * random.symmetric();
    chart.set_state(x, state);
  }
  double norm_error = 0, misalignment = 0;
  for (const Quat& q : state.frames) norm_error = std::max(norm_error, std::abs(q.norm() - 1));
  for (Index j = 0; j < state.edge_count(); ++j) {
    const Vec3 t = (state.nodes.col(j + 1) - state.nodes.col(j)).normalized();
    misalignment =
        std::max(misalignment, (third_axis(state.frames[static_cast<std::size_t>(j)]) - t).norm());
  }
  // each chart normalizes and starts from the tangent of the frame itself, so nothing adds up
  EXPECT_LT(norm_error, 1e-14);
  EXPECT_LT(misalignment, 1e-14);
  EXPECT_NO_THROW(check_state(state));
}

TEST(FrameChart, AnAngleTurnsItsFrameAndTwistsBothItsJoints) {
  const RodParams params;
  const RodState state = make_rod(testing::straight_nodes(4, 4), params);
  const FrameChart chart(state, HeldUnknowns::none(state));
  Eigen::VectorXd x = chart.unknowns();
  x[chart.unknown(2, 3)] = 7.5;  // more than a turn
  RodState turned = chart.reference();
  chart.set_state(x, turned);
  const std::vector<double> twists = joint_twists(turned);
  EXPECT_NEAR(twists[2], 7.5, 1e-14);
  EXPECT_NEAR(twists[3], -7.5, 1e-14);
  EXPECT_NEAR(twists[1], 0, 1e-15);
}

TEST(FrameChart, HeldUnknownsKeepTheirValue) {
  const RodParams params;
  const RodState state = random_rod(6, params, {.first_clamped = true}, 17);
  HeldUnknowns held = HeldUnknowns::none(state);
  held.hold_node(2);
  held.angle[3] = true;
  const FrameChart chart(state, held);
  EXPECT_EQ(chart.size(), 3 * 6 + 6 - 4);  // nodes and 5 edges and a clamp, less four held
  Eigen::VectorXd x = chart.unknowns();
  for (double& v : x) v += 0.05;
  RodState moved = chart.reference();
  chart.set_state(x, moved);
  EXPECT_EQ((moved.nodes.col(2) - state.nodes.col(2)).norm(), 0);
  EXPECT_GT((moved.nodes.col(3) - state.nodes.col(3)).norm(), 0.05);
}

}  // namespace
}  // namespace wirepack
