#include "wirepack/observe/order.hpp"

#include <gtest/gtest.h>

#include "../../support/sample_rods.hpp"
#include "../../support/strands.hpp"

namespace wirepack {
namespace {

using testing::random_rotation;

TEST(Order, OfEqualPlanarAndIsotropicAxesIsThatOfTheDefinition) {
  Points equal(3, 4);
  equal.colwise() = Vec3(1, 2, 2) / 3;
  equal.col(2) *= -1;  // an axis has no sign
  EXPECT_NEAR(axial_order(equal).order(), 1, 1e-14);
  EXPECT_NEAR(std::abs(axial_order(equal).director.dot(Vec3(1, 2, 2) / 3)), 1, 1e-14);
  EXPECT_NEAR(alignment(equal, Vec3(1, 2, 2) / 3), 1, 1e-14);
  EXPECT_NEAR(alignment(equal, Vec3(2, -2, 1) / 3), -0.5, 1e-14);

  const AxialOrder planar = axial_order(testing::ring_nodes(1, 8));
  EXPECT_LT((planar.eigenvalues - Vec3(0.25, 0.25, -0.5)).norm(), 1e-14);
  EXPECT_NEAR(axial_order(Mat3::Identity()).order(), 0, 1e-14);
  EXPECT_NEAR(alignment(Mat3::Identity(), Vec3(0.6, 0, 0.8)), 0, 1e-14);
  EXPECT_EQ(axial_order(Points(3, 0)).order(), 0);
  EXPECT_EQ(alignment(Points(3, 0), Vec3::UnitZ()), 0);
}

TEST(Order, TangentsOfASpoolLieInAPlane) {
  const RodState spool = make_rod(testing::helix_strand(8, 0.01, 5, 500), RodParams{});
  const AxialOrder order = axial_order(edge_tangents(spool));
  EXPECT_LT((order.eigenvalues - Vec3(0.25, 0.25, -0.5)).norm(), 1e-3);  // the pitch, squared
  const RodState straight = make_rod(testing::straight_nodes(10, 10), RodParams{});
  EXPECT_NEAR(axial_order(edge_tangents(straight)).order(), 1, 1e-14);
}

TEST(Order, CoilAxesOfASpoolAreItsAxisWhereverItIsAndAtAnyRadius) {
  Random random(5);
  const Quat turn = random_rotation(random);
  const Vec3 axis = turn * Vec3::UnitZ();
  // layers of helices one in the other, so that the radius changes on the way
  Points nodes(3, 900);
  for (Index layer = 0; layer < 3; ++layer) {
    Points turns = testing::helix_strand(10 - 2 * static_cast<double>(layer), 2, 6, 299);
    if (layer == 1) turns = turns.rowwise().reverse().eval();
    for (Index i = 0; i < 300; ++i) {
      nodes.col(300 * layer + i) = turn * Vec3(turns.col(i)) + Vec3(30, -20, 7);
    }
  }
  // one layer only, since at the change of layers the wire turns back on its way
  const RodState layer = make_rod(nodes.leftCols(300), RodParams{});
  const Points axes = coil_axes(layer);
  EXPECT_NEAR(static_cast<double>(axes.cols()), 250, 3);  // 5 of 6 turns have a turn ahead
  EXPECT_GT(axial_order(axes).order(), 0.99);  // one turn of a helix does not close: pitch / radius
  EXPECT_GT(alignment(axes, axis), 0.99);
  EXPECT_LT(alignment(axes, axis.unitOrthogonal()), -0.48);
  // right-handed: from the first node on the wire goes counterclockwise about +axis
  EXPECT_GT(Vec3(axes.col(10)).dot(axis), 0.99);
}

TEST(Order, CoilAxesOfLoopsInRandomDirectionsAreIsotropic) {
  Random random(6);
  const Index loops = 2000, per_loop = 24;
  Points nodes(3, loops * per_loop);
  Vec3 start = Vec3::Zero();
  for (Index k = 0; k < loops; ++k) {
    Vec3 axis = testing::random_vector(random);
    while (axis.norm() > 1) axis = testing::random_vector(random);  // evenly in all directions
    const Quat turn = frame_with_tangent(axis.normalized()) *
                      rotation_about(Vec3::UnitZ(), pi * random.symmetric());
    const Points ring = turn.toRotationMatrix() * testing::ring_nodes(5, per_loop);
    for (Index i = 0; i < per_loop; ++i) {
      nodes.col(k * per_loop + i) = start + Vec3(ring.col((i + 1) % per_loop) - ring.col(0));
    }
    start = nodes.col((k + 1) * per_loop - 1);
  }
  RodState state;  // only nodes are looked at; joints between loops may turn back
  state.nodes = nodes;
  const Points axes = coil_axes(state);
  EXPECT_GT(axes.cols(), 40000);
  // sd of an eigenvalue is about sqrt(1/5 / loops) = 0.01; 5 of them
  EXPECT_LT(axial_order(axes).order(), 0.05);
  EXPECT_LT(std::abs(alignment(axes, Vec3::UnitZ())), 0.05);
}

TEST(Order, AWireOfLessThanOneTurnHasNoCoilAxis) {
  EXPECT_EQ(coil_axes(make_rod(testing::helix_strand(8, 1, 0.97, 60), RodParams{})).cols(), 0);
  EXPECT_EQ(coil_axes(make_rod(testing::straight_nodes(10, 10), RodParams{})).cols(), 0);
  EXPECT_GT(coil_axes(make_rod(testing::helix_strand(8, 1, 1.1, 60), RodParams{})).cols(), 0);
}

}  // namespace
}  // namespace wirepack
