#include "wirepack/observe/coil_report.hpp"

#include <gtest/gtest.h>

#include "../../support/elastic_rest.hpp"
#include "../../support/sample_rods.hpp"
#include "../../support/strands.hpp"

namespace wirepack {
namespace {

// Turns around the axis through the origin, then as many the other way round beside it.
RodState figure_eight(double turns, Index edges_per_turn) {
  const auto half = static_cast<Index>(turns * static_cast<double>(edges_per_turn));
  Points nodes(3, 2 * half + 1);
  for (Index i = 0; i <= 2 * half; ++i) {
    const double angle =
        2 * pi * static_cast<double>(i - half) / static_cast<double>(edges_per_turn);
    const Vec3 on_circle(4 * std::cos(angle), 4 * std::sin(angle), 0);
    nodes.col(i) = i <= half ? on_circle : Vec3(8 - on_circle.x(), on_circle.y(), 0);
    nodes(2, i) = 0.01 * angle;
  }
  return make_rod(nodes, RodParams{});
}

TEST(CoilReport, ASpoolAroundTheFeedIsOrderedAndAlignedAndRunsOneWay) {
  const RodState spool = make_rod(testing::helix_strand(5, 0.2, 6, 240), RodParams{});
  const CoilReport report = coil_report(spool, Vec3::UnitZ());
  EXPECT_NEAR(report.axis_order, 1, 1e-3);  // axes tilt by pitch / (2 pi r)
  EXPECT_NEAR(report.feed_alignment, 1, 1e-3);
  EXPECT_EQ(report.reversals, 0);
  EXPECT_NEAR(coil_report(spool, Vec3::UnitX()).feed_alignment, -0.5, 1e-3);
}

TEST(CoilReport, LoopsThatTurnBackAreOrderedAndReversed) {
  const CoilReport report = coil_report(figure_eight(4, 40), Vec3::UnitZ());
  EXPECT_GT(report.axis_order, 0.7);  // less than 1 on the way from one sense to the other
  EXPECT_EQ(report.reversals, 1);
}

TEST(CoilReport, TheTipOfAStraightWireTurnsByItsTwist) {
  RodState wire = make_rod(testing::straight_nodes(20, 20), RodParams{});
  testing::twist_uniformly(wire,
                           20.0 / 19 * pi / 2);  // the middles of the end edges: a quarter turn
  const CoilReport report = coil_report(wire, Vec3::UnitZ());
  EXPECT_NEAR(report.tip_rotation(), 0.25, 1e-12);
  EXPECT_EQ(report.writhe, 0);
  EXPECT_EQ(report.axis_order, 0);
}

}  // namespace
}  // namespace wirepack
