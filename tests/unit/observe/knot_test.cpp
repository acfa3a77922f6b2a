#include "wirepack/observe/knot.hpp"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numeric>

#include "wirepack/core/random.hpp"

#include "../../support/strands.hpp"

namespace wirepack {
namespace {

using Curve = std::function<Vec3(double)>;

Points polygon(const Curve& curve, Index edges = 240) {
  Points nodes(3, edges);
  for (Index i = 0; i < edges; ++i) {
    nodes.col(i) = curve(2 * pi * static_cast<double>(i) / static_cast<double>(edges));
  }
  return nodes;
}

Curve torus(int p, int q) {
  return [=](double t) {
    const double r = 2 + std::cos(q * t);
    return Vec3(r * std::cos(p * t), r * std::sin(p * t), std::sin(q * t));
  };
}

Vec3 figure_eight(double t) {
  const double r = 2 + std::cos(2 * t);
  return {r * std::cos(3 * t), r * std::sin(3 * t), std::sin(4 * t)};
}

// Lissajous knot (3, 2, 7) with phases 0.7 and 0.2: 5_2 (Bogle et al. 1994)
Vec3 three_twist(double t) {
  return {std::cos(3 * t + 0.7), std::cos(2 * t + 0.2), std::cos(7 * t)};
}

TEST(Knot, of_standard_curves_has_the_name_and_determinant_of_the_tables) {
  struct Known {
    Curve curve;
    std::string name;
    std::uint32_t determinant;
  };
  const std::vector<Known> known{
      {torus(1, 0), "unknot", 1}, {torus(1, 7), "unknot", 1}, {torus(2, 3), "3_1", 3},
      {torus(3, 2), "3_1", 3},    {figure_eight, "4_1", 5},   {torus(2, 5), "5_1", 5},
      {three_twist, "5_2", 7},    {torus(2, 7), "7_1", 7},    {torus(3, 4), "", 3}};  // 8_19
  for (const Known& k : known) {
    const Points nodes = polygon(k.curve);
    for (const Points& mirrored : {nodes, Points(-nodes)}) {
      EXPECT_EQ(knot_type(mirrored).name, k.name);
      EXPECT_EQ(knot_type(mirrored).determinant, k.determinant) << k.name;
    }
  }
}

TEST(Knot, of_two_knots_on_one_string_is_their_sum) {
  // opened where they are outermost, and joined
  const Points trefoil = polygon(torus(2, 3)), eight = polygon(figure_eight);
  const auto from_outermost = [](const Points& nodes) {
    Index far = 0;
    nodes.row(0).maxCoeff(&far);
    Points turned(3, nodes.cols());
    turned << nodes.rightCols(nodes.cols() - far), nodes.leftCols(far);
    return turned;
  };
  Points joined(3, trefoil.cols() + eight.cols());
  const Vec3 turn(-1, -1, 1);
  joined << from_outermost(trefoil),
      (turn.asDiagonal() * from_outermost(eight)).colwise() + Vec3(7, 0, 0);
  EXPECT_EQ(knot_type(joined).name, "3_1#4_1");
  EXPECT_EQ(knot_type(joined).determinant, 15U);
}

// Rises all the way, so that it has no knot, and is led back outside.
Points rising_tangle(Index count) {
  Random random(9);
  Points nodes(3, count + 2);
  for (Index i = 0; i < count; ++i) {
    nodes.col(i) = Vec3(random.symmetric(), random.symmetric(), 0.01 * static_cast<double>(i));
  }
  nodes.col(count) = Vec3(9, 0, 0.01 * static_cast<double>(count));
  nodes.col(count + 1) = Vec3(9, 0, 0);
  return nodes;
}

TEST(Knot, of_a_tangle_of_thousands_of_crossings_without_a_knot_is_the_unknot) {
  const KnotType found = knot_type(rising_tangle(200));  // 4600 crossings seen from above
  EXPECT_EQ(found.name, "unknot");
  EXPECT_EQ(found.determinant, 1U);
}

TEST(Knot, of_an_open_wire_is_closed_far_outside) {
  // a trefoil whose outermost edge is missing, about the origin
  const Points nodes = polygon(torus(2, 3));
  Index far = 0;
  nodes.colwise().norm().maxCoeff(&far);
  Points open(3, nodes.cols());
  open << nodes.rightCols(nodes.cols() - far), nodes.leftCols(far);
  EXPECT_EQ(knot_type(closed_outside(open)).name, "3_1");
  EXPECT_EQ(knot_type(closed_outside(testing::helix_strand(3, 0.5, 20, 900))).name, "unknot");
}

}  // namespace
}  // namespace wirepack
