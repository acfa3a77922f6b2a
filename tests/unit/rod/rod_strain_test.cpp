#include "wirepack/rod/rod_strain.hpp"

#include <gtest/gtest.h>

#include "wirepack/core/lanes.hpp"
#include "wirepack/core/rotation.hpp"
#include "wirepack/rod/joint_strain.hpp"

#include "../../support/sample_rods.hpp"
#include "../../support/strain_of_turn.hpp"

namespace wirepack {
namespace {

using testing::random_rotation;
using testing::random_vector;
using testing::strain_of_turn;

Quat negative(const Quat& q) { return {-q.w(), -q.x(), -q.y(), -q.z()}; }

// A joint that twists by `twist`, half before and half after it bends by `angle` about an axis in
// the cross-section at `azimuth`.
Quat joint(double twist, double angle, double azimuth) {
  const Quat half_twist = rotation_about(Vec3::UnitZ(), twist / 2);
  return half_twist * rotation_about(Vec3(std::cos(azimuth), std::sin(azimuth), 0), angle) *
         half_twist;
}

TEST(JointStrain, BendingIsTheMeanSquareOfChordAndTangentAboutTheAxisOfTheTurn) {
  for (const double angle : {1e-6, 0.1, 1.0, 2.0, 3.1}) {
    for (const double azimuth : {0.0, 0.7, 2.5, -1.9}) {
      const Vec3 strain = joint_strain(Quat::Identity(), joint(0, angle, azimuth), 0);
      const double length = strain_of_turn(angle);
      // relative round-off; near pi the tangent magnifies it by 50
      EXPECT_NEAR(strain.x(), length * std::cos(azimuth), 1e-13 * length * (1 + length));
      EXPECT_NEAR(strain.y(), length * std::sin(azimuth), 1e-13 * length * (1 + length));
      EXPECT_NEAR(strain.z(), 0, 1e-14 * (1 + length));
    }
  }
}

TEST(JointStrain, bending_is_the_turning_angle_to_fourth_order) {
  for (const double angle : {0.05, 0.2, 0.5}) {
    const double strain = joint_strain(Quat::Identity(), joint(0, angle, 0), 0).x();
    const double fourth_order = 7.0 / 1440 * std::pow(angle, 4);  // half of that of the square
    EXPECT_NEAR(strain / angle - 1, fourth_order, 0.2 * angle * angle * fourth_order);
  }
}

TEST(JointStrain, bending_grows_without_bound_towards_a_turn_of_pi) {
  for (const double rest : {1e-2, 1e-3, 1e-4}) {
    const double strain = joint_strain(Quat::Identity(), joint(0, pi - rest, 0), 0).x();
    EXPECT_NEAR(strain * rest, 4 / std::sqrt(3.0), 2 * rest);
  }
}

TEST(JointStrain, BendingDoesNotDependOnTheRelativeTwistNorTwistOnBending) {
  for (const double twist : {0.0, 0.3, -1.5, 3.0, -3.0, 3.3, 10.0, 20 * pi + 0.1}) {
    for (const double angle : {0.0, 0.4, 2.0}) {
      const Vec3 strain = joint_strain(Quat::Identity(), joint(twist, angle, 0.7), twist);
      EXPECT_NEAR(strain.x(), strain_of_turn(angle) * std::cos(0.7), 1e-12) << twist;
      EXPECT_NEAR(strain.y(), strain_of_turn(angle) * std::sin(0.7), 1e-12) << twist;
      EXPECT_NEAR(strain.z(), twist, 1e-12) << angle;  // round-off of 60
    }
  }
}

TEST(JointStrain, OfFourJointsAtATimeIsThatOfEachForAnyTurnsOfTwist) {
  Random random(9);
  for (int k = 0; k < 1000; ++k) {
    std::vector<Quat> before(4), after(4);
    for (Quat& q : before) q = random_rotation(random);
    for (Quat& q : after) q = random_rotation(random);
    const std::vector<double> guide{0, 6 * random.symmetric(), 60 * random.symmetric(), 4 * pi};
    const auto four = joint_strain(load_quats<Lanes>(before.data(), 0),
                                   load_quats<Lanes>(after.data(), 0), load<Lanes>(guide.data()));
    for (std::size_t i = 0; i < 4; ++i) {
      const JointStrain one = joint_strain_derivative(before[i], after[i], guide[i]);
      // near a turn of pi bending magnifies round-off, its derivative twice
      const double rounding = 1e-13 * (1 + one.value.squaredNorm());
      EXPECT_LT((lane(four.value, static_cast<int>(i)) - one.value).norm(), rounding);
      Mat3 by_spin;
      by_spin.row(0) = lane(four.bend1_by_spin, static_cast<int>(i));
      by_spin.row(1) = lane(four.bend2_by_spin, static_cast<int>(i));
      by_spin.row(2) = lane(four.twist_by_spin, static_cast<int>(i));
      EXPECT_LT((by_spin - one.by_spin).norm(), rounding);
      EXPECT_LE(std::abs(one.value.z() - guide[i]), pi * (1 + 1e-15));
    }
  }
}

TEST(JointStrain, IsTheSameForAQuaternionAndItsNegative) {
  Random random(3);
  for (int k = 0; k < 100; ++k) {
    const Quat before = random_rotation(random), after = random_rotation(random);
    const double guide = 10 * random.symmetric();
    const Vec3 strain = joint_strain(before, after, guide);
    const double tolerance = 1e-13 * (1 + strain.norm());  // signs alone change
    EXPECT_LT((joint_strain(negative(before), after, guide) - strain).norm(), tolerance);
    EXPECT_LT((joint_strain(before, negative(after), guide) - strain).norm(), tolerance);
    EXPECT_LT((joint_strain(negative(before), negative(after), guide) - strain).norm(), tolerance);
  }
}

TEST(JointStrain, IsTheSameInAnyRotatedWorld) {
  Random random(5);
  for (int k = 0; k < 100; ++k) {
    const Quat before = random_rotation(random), after = random_rotation(random);
    const Quat world = random_rotation(random);
    const Vec3 strain = joint_strain(before, after, 0);
    EXPECT_LT((joint_strain(world * before, world * after, 0) - strain).norm(),
              1e-12 * (1 + strain.squaredNorm()));  // near a turn of pi the tangent magnifies
  }
}

TEST(JointStrain, FollowsTenTurnsContinuouslyByItsGuide) {
  double guide = 0;
  for (int step = 1; step <= 200; ++step) {
    const double twist = 20 * pi * step / 200;
    const Vec3 strain = joint_strain(Quat::Identity(), joint(twist, 0.5, 0.7), guide);
    EXPECT_NEAR(strain.z(), twist, 1e-12);
    EXPECT_NEAR(strain.y(), strain_of_turn(0.5) * std::sin(0.7), 1e-12);  // no change of sign
    guide = strain.z();
  }
  EXPECT_NEAR(guide, 20 * pi, 1e-12);
}

TEST(JointStrain, HasTheAngleBetweenTheTangentsForItsBending) {
  Random random(7);
  for (int k = 0; k < 50; ++k) {
    const Quat before = random_rotation(random);
    const Quat after =
        before * joint(random.symmetric(), 1 + random.symmetric(), 3 * random.symmetric());
    const Vec3 t0 = third_axis(before), t1 = third_axis(after);
    const double length = joint_strain(before, after, 0).head<2>().norm();
    const double exact = strain_of_turn(std::atan2(t0.cross(t1).norm(), t0.dot(t1)));
    EXPECT_NEAR(length, exact, 1e-13 * (1 + exact * exact));
  }
}

TEST(JointStrain, DerivativeBySpinMatchesDifferences) {
  Random random(11);
  for (int k = 0; k < 30; ++k) {
    const Quat before = random_rotation(random);
    const Quat after = before * joint(3 * random.symmetric(), 1.2 * random.symmetric(), 0.3);
    const JointStrain strain = joint_strain_derivative(before, after, 0);
    EXPECT_LT((strain.value - joint_strain(before, after, 0)).norm(), 1e-14);
    const Vec3 spin = random_vector(random);
    constexpr double h = 1e-6;
    const auto at = [&](double sign) {
      return joint_strain(before, rotation_about(spin.normalized(), sign * h * spin.norm()) * after,
                          strain.value.z());
    };
    const Vec3 numeric = (at(1) - at(-1)) / (2 * h);
    const Vec3 analytic = strain.by_spin * (before.conjugate() * spin);
    EXPECT_GT(analytic.norm(), 1e-3);
    EXPECT_LT((numeric - analytic).norm(), 1e-8);  // rounding 1e-16 over 1e-6, and h^2
  }
}

TEST(EdgeStrain, IsTheRelativeChangeOfLengthWithTheInletOnItsOwnRestLength) {
  RodParams params;
  params.edge_length = 2;
  RodState state = make_rod(testing::straight_nodes(3, 6.6), params);
  state.inlet_rest_length = 1.1;
  EXPECT_NEAR(edge_strain(state, params, 0), 0.1, 1e-14);
  EXPECT_NEAR(edge_strain(state, params, 2), 1.0, 1e-14);
}

}  // namespace
}  // namespace wirepack
