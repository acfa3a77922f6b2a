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

// A spool of hoops about z whose sections are a hexagonal lattice.
RodState hexagonal_spool(double d) {
  std::vector<Vec3> nodes;
  for (int layer = 0; layer < 8; ++layer) {
    for (int row = -6; row <= 6; ++row) {
      const double radius = 20 + layer * d * std::sqrt(3.0) / 2;
      const double height = d * (row + 0.5 * (layer % 2));
      for (int k = 0; k < 180; ++k) {
        const double angle = 2 * pi * k / 180;
        nodes.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
      }
    }
  }
  RodState state;
  state.nodes.resize(3, static_cast<Index>(nodes.size()));
  for (Index i = 0; i < state.nodes.cols(); ++i) {
    state.nodes.col(i) = nodes[static_cast<std::size_t>(i)];
  }
  return state;
}

TEST(StrandSpacing, of_a_hexagonal_spool_is_its_lattice_constant_across_the_strands) {
  const double d = 2.81;
  const StrandSpacing spacing = strand_spacing(hexagonal_spool(d));
  EXPECT_GT(spacing.pairs, 1000);
  EXPECT_NEAR(spacing.across, d, 0.01 * d);
  EXPECT_GT(spacing.hexagonal_order, 0.95);  // the planes see hoops of finite curvature aslant
  // a plane that holds the axis cuts them at right angles
  const StrandSpacing straight = strand_spacing(hexagonal_spool(d), Vec3(1, 0.01, 0));
  EXPECT_NEAR(straight.mean, d, 1e-3 * d);
  EXPECT_NEAR(straight.hexagonal_order, 1, 1e-3);
}

TEST(StrandSpacing, of_a_square_lattice_with_one_diagonal_has_a_hexagonal_order_of_a_third) {
  // not quite square, so that one diagonal of each cell is an edge; it is in the first shell too
  Eigen::Matrix2Xd points(2, 400);
  for (Index i = 0; i < 400; ++i) {
    points.col(i) =
        Eigen::Vector2d(static_cast<double>(i % 20) + 1e-4 * static_cast<double>(i / 20),
                        static_cast<double>(i / 20));
  }
  // of six neighbours the four along the axes give 1 and -1 in turn, those on the diagonal -i; the
  // border has fewer
  EXPECT_NEAR(delaunay_spacing(points).hexagonal_order, 1.0 / 3, 0.01);
}

}  // namespace
}  // namespace wirepack
