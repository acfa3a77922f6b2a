#include "wirepack/contact/surface_slip.hpp"

#include <gtest/gtest.h>

#include "wirepack/core/random.hpp"

namespace wirepack {
namespace {

Vec3 random_vector(Random& random) {
  return {random.symmetric(), random.symmetric(), random.symmetric()};
}

RodState crumpled(Random& random) {
  Points nodes(3, 12);
  Vec3 at = Vec3::Zero();
  for (Index i = 0; i < nodes.cols(); ++i) {
    nodes.col(i) = at;
    at += Vec3(1, 0, 0) + 0.8 * random_vector(random);
  }
  return make_rod(nodes, RodParams{});
}

// Rotation vector of every edge for these velocities of the nodes and spins about the tangents.
Points turning(const RodState& rod, const Points& velocity, const Eigen::VectorXd& spin) {
  Points result(3, rod.edge_count());
  for (Index j = 0; j < rod.edge_count(); ++j) {
    const Vec3 e = rod.nodes.col(j + 1) - rod.nodes.col(j);
    result.col(j) =
        e.cross(velocity.col(j + 1) - velocity.col(j)) / e.squaredNorm() + spin[j] * e.normalized();
  }
  return result;
}

SurfaceSlip some_touch(const RodState& rod, double s, double t) {
  const auto point = [&](Index edge, double u) -> Vec3 {
    return (0.5 - u) * rod.nodes.col(edge) + (0.5 + u) * rod.nodes.col(edge + 1);
  };
  return strand_slip(rod, 2, s, 8, t, point(2, s) - point(8, t));
}

TEST(SurfaceSlip, ARigidMotionMakesNoStrandsSlide) {
  Random random(3);
  const RodState rod = crumpled(random);
  const Vec3 omega = random_vector(random), shift = random_vector(random);
  Points velocity(3, rod.node_count());
  for (Index i = 0; i < rod.node_count(); ++i) {
    velocity.col(i) = shift + omega.cross(Vec3(rod.nodes.col(i)));
  }
  // every edge also turns about itself with the rotation
  Points edge_rotation(3, rod.edge_count());
  edge_rotation.colwise() = omega;
  EXPECT_LT(some_touch(rod, 0.3, -1.2).of(velocity, edge_rotation).norm(), 1e-14);
}

TEST(SurfaceSlip, AWireThatRollsOnTheWallDoesNotSlideAndOneThatDoesNotTurnDoes) {
  const double a = 0.7, speed = 2;
  Points nodes(3, 3);
  nodes << -1, 0, 1, 0, 0, 0, -9, -9, -9;  // along x, on the bottom of a cavity
  const RodState rod = make_rod(nodes, RodParams{});
  Points velocity(3, 3);
  velocity.colwise() = Vec3(0, speed, 0);
  const SurfaceSlip slip = wall_slip(rod, 1, a, Cavity{});
  const Points rolling = turning(rod, velocity, Eigen::Vector2d::Constant(-speed / a));
  EXPECT_LT(slip.of(velocity, rolling).norm(), 1e-14);
  EXPECT_NEAR(slip.of(velocity, 0 * rolling).y(), speed, 1e-14);
  EXPECT_NEAR(wall_slip(rod, 0, a, Cavity{}).of(velocity, 0 * rolling).y(), speed, 1e-14);
}

TEST(SurfaceSlip, EqualSpinsOfParallelStrandsRubAndOppositeOnesRoll) {
  Points nodes(3, 6);
  nodes << 0, 1, 2, 2, 1, 0,  //
      0, 0, 0, 2, 2, 2,       //
      0, 0, 0, 0, 0, 0;
  const RodState rod = make_rod(nodes, RodParams{});
  const Points rest = Points::Zero(3, 6);
  const SurfaceSlip slip = strand_slip(rod, 0, 0, 4, 0, Vec3(0, -2, 0));
  Points turn = Points::Zero(3, 5);
  turn.col(0) = Vec3(0.1, 0, 0);
  turn.col(4) = Vec3(0.1, 0, 0);
  EXPECT_NEAR(slip.of(rest, turn).z(), 0.2, 1e-15);  // two surfaces, radius 1, 0.1 each
  turn.col(4) = Vec3(-0.1, 0, 0);
  EXPECT_NEAR(slip.of(rest, turn).norm(), 0, 1e-15);
}

TEST(SurfaceSlip, ForcesAndMomentsAreTheTransposeOfTheSlipAndAddUpToNothing) {
  Random random(5);
  const RodState rod = crumpled(random);
  for (const SurfaceSlip& slip : {some_touch(rod, 0.3, -1.2), wall_slip(rod, 4, 1.0, Cavity{})}) {
    Points velocity(3, rod.node_count()), rotation(3, rod.edge_count());
    for (double& v : velocity.reshaped()) v = random.symmetric();
    for (double& v : rotation.reshaped()) v = random.symmetric();
    const Vec3 f = slip.tangential(random_vector(random));
    Points force = Points::Zero(3, rod.node_count()), moment = Points::Zero(3, rod.edge_count());
    slip.add_force(f, force, moment);
    EXPECT_NEAR(f.dot(slip.of(velocity, rotation)),
                force.cwiseProduct(velocity).sum() + moment.cwiseProduct(rotation).sum(), 1e-14);
  }
  Points force = Points::Zero(3, rod.node_count()), moment = Points::Zero(3, rod.edge_count());
  some_touch(rod, 0.3, -1.2).add_force(random_vector(random), force, moment);
  Vec3 about_origin = moment.rowwise().sum();
  for (Index i = 0; i < rod.node_count(); ++i) {
    about_origin += Vec3(rod.nodes.col(i)).cross(Vec3(force.col(i)));
  }
  EXPECT_LT(force.rowwise().sum().norm(), 1e-14);
  EXPECT_LT(about_origin.norm(), 1e-13);
}

}  // namespace
}  // namespace wirepack
