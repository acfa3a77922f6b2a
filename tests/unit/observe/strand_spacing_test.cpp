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

TEST(StrandSpacing, OfACoilIsTheDistanceOfItsTurnsAndLayers) {
  // hoops of a spool about z: layers at radii 5 and 5 + d, turns d apart, all crossed by upright planes
  const double d = 2.3;
  std::vector<Vec3> nodes;
  for (int layer = 0; layer < 3; ++layer) {
    for (int turn = 0; turn < 5; ++turn) {
      for (int k = 0; k < 60; ++k) {
        const double angle = 2 * pi * k / 60, radius = 5 + std::sqrt(3.0) / 2 * d * layer;
        const double height = d * (turn + (layer % 2 == 0 ? 0 : 0.5)) - 2.2 * d;
        nodes.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
      }
    }
  }
  Points points(3, static_cast<Index>(nodes.size()));
  for (Index i = 0; i < points.cols(); ++i) points.col(i) = nodes[static_cast<std::size_t>(i)];
  RodState state;
  state.nodes = points;
  const StrandSpacing spacing = strand_spacing(state);
  EXPECT_GT(spacing.pairs, 20);
  // planes aslant to the hoops see them further apart, by up to 1 / 0.7
  EXPECT_GT(spacing.mean, d);
  EXPECT_LT(spacing.mean, 1.3 * d);
}

}  // namespace
}  // namespace wirepack
