#include "wirepack/observe/strand_spacing.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

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
  EXPECT_EQ(delaunay_spacing(points).pairs, 6 * 7 + 7 * 6 + 6 * 6);  // in three directions
}

TEST(StrandSpacing, OfTwoRowsCountsTheirNeighboursAndNotTheLongEdgesOfTheHull) {
  const double d = 2.3;
  Eigen::Matrix2Xd points(2, 20);
  for (Index i = 0; i < 10; ++i) {
    const double height = d * static_cast<double>(i);
    points.col(2 * i) = Eigen::Vector2d(0, height);
    points.col(2 * i + 1) = Eigen::Vector2d(std::sqrt(3.0) / 2 * d, height + d / 2);
  }
  const StrandSpacing spacing = delaunay_spacing(points);
  EXPECT_EQ(spacing.pairs, 19 + 2 * 9);  // the zigzag, and along both rows
  EXPECT_NEAR(spacing.mean, d, 1e-12);
}

TEST(StrandSpacing, OfHexagonallyPackedStrandsIsTheirDistanceInPlanesThatTheyCrossSteeply) {
  // a bundle of straight strands along z, joined far outside
  const double d = 2.5;
  std::vector<Vec3> nodes;
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) {
      const double x = d * (i - 4 + 0.5 * (j % 2)), y = d * std::sqrt(3.0) / 2 * (j - 4);
      const double sense = (9 * i + j) % 2 == 0 ? 1 : -1;
      nodes.emplace_back(x, y, -80 * sense);
      nodes.emplace_back(x, y, 80 * sense);
    }
  }
  RodState state;
  state.nodes.resize(3, static_cast<Index>(nodes.size()));
  for (Index i = 0; i < state.nodes.cols(); ++i) {
    state.nodes.col(i) = nodes[static_cast<std::size_t>(i)];
  }
  const StrandSpacing across = strand_spacing(state, Vec3::UnitZ());
  EXPECT_GT(across.pairs, 150);
  EXPECT_NEAR(across.mean, d, 1e-9);
  // 60 degrees off: |t.n| = 1/2, too flat to count
  EXPECT_EQ(strand_spacing(state, Vec3(std::sqrt(3.0), 0, 1)).pairs, 0);
}

}  // namespace
}  // namespace wirepack
