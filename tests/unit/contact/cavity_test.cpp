#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/contact/wall_point.hpp"
#include "wirepack/core/random.hpp"

namespace wirepack {
namespace {

const std::vector<Vec3>& ellipsoids() {
  static const std::vector<Vec3> axes{Vec3(10, 10, 8), Vec3(12, 10, 10), Vec3(9, 4, 6)};
  return axes;
}

Vec3 random_direction(Random& random) {
  Vec3 v;
  do {
    v = Vec3(random.symmetric(), random.symmetric(), random.symmetric());
  } while (v.norm() > 1 || v.norm() < 0.1);
  return v.normalized();
}

TEST(Cavity, gap_and_normal_of_an_ellipsoid_are_those_of_the_nearest_point_of_its_wall) {
  Random random(3);
  for (const Vec3& axes : ellipsoids()) {
    const Cavity cavity = ellipsoid(axes);
    for (int k = 0; k < 200; ++k) {
      const Vec3 on_wall = axes.cwiseProduct(random_direction(random));
      const Vec3 normal = on_wall.cwiseQuotient(axes.cwiseProduct(axes)).normalized();
      const double depth = 0.9 * smallest_wall_radius(cavity) * random.symmetric();
      const Vec3 point = on_wall - depth * normal;
      EXPECT_NEAR(wall_gap(cavity, point, 1), depth - 1, 1e-12) << axes.transpose() << " " << depth;
      EXPECT_LT((outward_normal(cavity, point) - normal).norm(), 1e-10) << depth;
    }
  }
}

TEST(Cavity, an_ellipsoid_of_equal_axes_is_a_sphere) {
  Random random(4);
  const Cavity sphere{7}, same = ellipsoid(Vec3::Constant(7));
  EXPECT_NEAR(same.radius, 7, 1e-14);
  for (int k = 0; k < 50; ++k) {
    const Vec3 point = (6.5 + random.symmetric()) * random_direction(random);
    const double overlap = -wall_gap(sphere, point, 1);
    EXPECT_NEAR(-wall_gap(same, point, 1), overlap, 1e-13);
    EXPECT_LT((outward_normal(same, point) - outward_normal(sphere, point)).norm(), 1e-13);
    EXPECT_LT(
        (contact_hessian(same, point, overlap, 1) - contact_hessian(sphere, point, overlap, 1))
            .norm(),
        1e-13);
  }
}

TEST(Cavity, hessian_of_the_overlap_matches_differences_in_an_ellipsoid) {
  Random random(5);
  const double step = 1e-5;
  for (const Vec3& axes : ellipsoids()) {
    const Cavity cavity = ellipsoid(axes);
    const auto force = [&](const Vec3& at) {
      return Vec3(-wall_gap(cavity, at, 1) * outward_normal(cavity, at));
    };
    for (int k = 0; k < 20; ++k) {
      const Vec3 point = touching_point(cavity, random_direction(random), 0.5);
      EXPECT_NEAR(wall_gap(cavity, point, 0.5), 0, 1e-12);
      const Mat3 hessian = contact_hessian(cavity, point, -wall_gap(cavity, point, 1), 1);
      for (Index c = 0; c < 3; ++c) {
        const Vec3 move = step * Vec3::Unit(c);
        const Vec3 by_difference = (force(point + move) - force(point - move)) / (2 * step);
        EXPECT_LT((hessian.col(c) - by_difference).norm(), 1e-8);
      }
    }
  }
}

TEST(Cavity, no_point_inside_of_an_ellipsoid_touches_that_is_farther_than_a_wire_radius) {
  Random random(6);
  for (const Vec3& axes : {Vec3(10, 10, 4.6), Vec3(20, 20, 6.4), Vec3(9, 4.3, 5)}) {
    const Cavity cavity = ellipsoid(axes);
    EXPECT_GE(smallest_wall_radius(cavity), 2);
    Points wall(3, 60000);
    for (Index k = 0; k < wall.cols(); ++k)
      wall.col(k) = axes.cwiseProduct(random_direction(random));
    for (int k = 0; k < 300; ++k) {
      Vec3 point = std::abs(random.symmetric()) * axes.cwiseProduct(random_direction(random));
      if (k % 3 == 0) point[k % 9 / 3] = 0;  // where nearest points may be two
      if (k == 0) point.setZero();
      const double distance = (wall.colwise() - point).colwise().norm().minCoeff();
      const double gap = wall_gap(cavity, point, 1);
      EXPECT_LT(gap, distance - 1 + 1e-9) << point.transpose();
      if (distance <= 1.1) continue;
      EXPECT_GT(gap, 0) << point.transpose() << " in " << axes.transpose();
    }
  }
}

TEST(Cavity, lanes_of_points_are_where_the_points_are) {
  Random random(7);
  const Ellipsoid shape{Vec3(9, 4, 6)};
  Points points(3, 4);
  for (Index k = 0; k < 4; ++k) points.col(k) = 3.6 * random_direction(random);
  const WallPoint<Lanes> lanes = wall_point(shape, load_columns<Lanes>(points, 0), 1);
  for (int k = 0; k < 4; ++k) {
    const WallPoint<double> alone = wall_point(shape, triple(Vec3(points.col(k))), 1);
    EXPECT_NEAR(lanes.gap[static_cast<std::size_t>(k)], alone.gap, 1e-13);
    EXPECT_LT((lane(lanes.outward, k) - vec3(alone.outward)).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace wirepack
