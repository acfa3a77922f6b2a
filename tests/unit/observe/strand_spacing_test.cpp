#include "wirepack/observe/strand_spacing.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace wirepack {
namespace {

TEST(StrandSpacing, OfAHexagonalLatticeIsItsConstant) {
  const double d = 2.81;
  Eigen::Matrix2Xd points(2, 49);
  for (Index i = 0; i < 49; ++i) {
    const auto row = static_cast<double>(i / 7), column = static_cast<double>(i % 7);
    points.col(i) = d * Eigen::Vector2d(column + row / 2, std::sqrt(3.0) / 2 * row);
  }
  EXPECT_NEAR(delaunay_spacing(points).mean, d, 1e-12);
  EXPECT_EQ(delaunay_spacing(points).pairs,
            6 * 7 + 6 * 7 + 6 * 6 - 4 * 6);  // all edges but the hull
}

TEST(StrandSpacing, OfAHelixOfWireIsThePitchWhereAPlaneCutsItsTurns) {
  // Turns of radius 6, seen by a plane through the axis as two rows of crossings: neighbours in a row
  // are a pitch apart, and all edges of a row but those between both rows are on the hull. A second,
  // outer layer makes inner edges of the first.
  const double d = 2.3;
  Eigen::Matrix2Xd points(2, 20);
  for (Index i = 0; i < 10; ++i) {
    const double height = d * static_cast<double>(i);
    points.col(2 * i) = Eigen::Vector2d(0, height);
    points.col(2 * i + 1) = Eigen::Vector2d(std::sqrt(3.0) / 2 * d, height + d / 2);
  }
  const StrandSpacing spacing = delaunay_spacing(points);
  EXPECT_EQ(spacing.pairs, 19 - 2);  // the zigzag between the rows, without both ends
  EXPECT_NEAR(spacing.mean, d, 1e-12);
}

TEST(StrandSpacing, CountsStrandsThatCrossAPlaneSteeplyAlone) {
  // three upright strands, 3 apart, and one that lies almost in the planes that they cross
  Points nodes(3, 8);
  nodes << 0, 0, 3, 3, 0, 0, -5, 5,  //
      0, 0, 0, 0, 2.6, 2.6, 1, 1,    //
      -40, 40, 40, -40, -40, 40, 0.1, -0.1;
  RodState state;
  state.nodes = nodes;
  EXPECT_EQ(strand_spacing(state).pairs, 0);  // three points have a hull only
}

}  // namespace
}  // namespace wirepack
