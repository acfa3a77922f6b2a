#include "wirepack/core/rotation.hpp"

#include <gtest/gtest.h>

#include "../../support/sample_rods.hpp"

namespace wirepack {
namespace {

using testing::random_rotation;
using testing::random_vector;

constexpr double rounding = 1e-14;

TEST(Rotation, AboutAnAxisGoesCounterclockwise) {
  const Vec3 turned = rotation_about(Vec3::UnitZ(), pi / 2) * Vec3::UnitX();
  EXPECT_LT((turned - Vec3::UnitY()).norm(), rounding);
  const Vec3 by_formula = Eigen::AngleAxisd(0.7, Vec3(1, 2, 2) / 3) * Vec3(0.3, -1, 2);
  EXPECT_LT((rotation_about(Vec3(1, 2, 2) / 3, 0.7) * Vec3(0.3, -1, 2) - by_formula).norm(),
            rounding);
}

TEST(Rotation, ThirdAxisIsTheImageOfZ) {
  Random random(1);
  for (int k = 0; k < 100; ++k) {
    const Quat q = random_rotation(random);
    EXPECT_LT((third_axis(q) - q * Vec3::UnitZ()).norm(), rounding);
  }
}

TEST(Rotation, TransportTakesOneVectorToTheOtherWithoutTurningAboutThem) {
  Random random(2);
  for (int k = 0; k < 100; ++k) {
    const Vec3 from = random_vector(random).normalized(), to = random_vector(random).normalized();
    const Quat q = transport(from, to);
    EXPECT_NEAR(q.norm(), 1, 1e-12);  // errors grow towards opposite vectors
    EXPECT_LT((q * from - to).norm(), 1e-12);
    EXPECT_LT(std::abs(q.vec().dot(from)), 1e-12);  // the axis is normal to both
    EXPECT_LT(std::abs(q.vec().dot(to)), 1e-12);
    EXPECT_LT(q.vec().cross(from.cross(to)).norm(), 1e-12);
  }
  EXPECT_LT((transport(Vec3::UnitX(), Vec3::UnitX()).coeffs() - Quat::Identity().coeffs()).norm(),
            rounding);
}

TEST(Rotation, TransportAroundAnOctantTurnsByARightAngle) {
  // V2.1: x -> y -> z -> x encloses an eighth of the sphere, so the turn about x is its area pi / 2
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  const Quat around = transport(z, x) * transport(y, z) * transport(x, y);
  const Quat expected = rotation_about(x, pi / 2);
  EXPECT_LT((around * y - expected * y).norm(), rounding);
  EXPECT_LT((around * z - expected * z).norm(), rounding);
}

TEST(Rotation, AFrameIsFoundForEveryTangentAlsoDownwards) {
  Random random(3);
  std::vector<Vec3> tangents{Vec3::UnitZ(), -Vec3::UnitZ(), Vec3(1e-9, 0, -1).normalized(),
                             Vec3(0.4, 0.2, -0.9).normalized()};
  for (int k = 0; k < 100; ++k) tangents.push_back(random_vector(random).normalized());
  for (const Vec3& tangent : tangents) {
    const Quat frame = frame_with_tangent(tangent);
    EXPECT_NEAR(frame.norm(), 1, 1e-14);
    EXPECT_LT((third_axis(frame) - tangent).norm(), 1e-14) << tangent.transpose();
  }
}

TEST(Rotation, NearestTurnStaysWithinHalfATurnOfItsGuide) {
  EXPECT_DOUBLE_EQ(nearest_turn(0.3, 0.1), 0.3);
  EXPECT_DOUBLE_EQ(nearest_turn(0.3, 6.5), 0.3 + 2 * pi);
  EXPECT_DOUBLE_EQ(nearest_turn(3, -20), 3 - 8 * pi);
  for (double guide = -30; guide < 30; guide += 0.37) {
    EXPECT_LE(std::abs(nearest_turn(1, guide) - guide), pi);
  }
}

}  // namespace
}  // namespace wirepack
