#include "wirepack/core/lanes.hpp"

#include <gtest/gtest.h>

#include "../../support/sample_rods.hpp"

namespace wirepack {
namespace {

using testing::random_rotation;
using testing::random_vector;

TEST(Lanes, HoldSuccessiveColumnsAndQuaternionsAndWriteThemBack) {
  Random random(1);
  Points points(3, 6), copy = Points::Zero(3, 6);
  for (auto&& p : points.colwise()) p = random_vector(random);
  const Triple<Lanes> v = load_columns<Lanes>(points, 1);
  std::vector<Quat> quats(6, Quat::Identity()), quat_copy = quats;
  for (Quat& q : quats) q = random_rotation(random);
  const QuatOf<Lanes> q = load_quats<Lanes>(quats.data(), 1);
  for (int k = 0; k < lane_count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    EXPECT_EQ(Vec3(v.x[i], v.y[i], v.z[i]), Vec3(points.col(1 + k)));
    EXPECT_EQ(Quat(q.w[i], q.x[i], q.y[i], q.z[i]).coeffs(), quats[1 + i].coeffs());
  }
  store_columns(v, copy, 1);
  store_quats(q, quat_copy.data(), 1);
  EXPECT_EQ(copy.middleCols(1, 4), points.middleCols(1, 4));
  EXPECT_TRUE(copy.col(0).isZero() && copy.col(5).isZero());
  for (std::size_t i = 1; i < 5; ++i) EXPECT_EQ(quat_copy[i].coeffs(), quats[i].coeffs());
  EXPECT_EQ(quat_copy[0].coeffs(), Quat::Identity().coeffs());
  EXPECT_EQ(quat_copy[5].coeffs(), Quat::Identity().coeffs());
}

TEST(Lanes, EveryNumberIsVisitedOnceInLanesOrAlone) {
  for (Index count = 0; count < 10; ++count) {
    std::vector<double> numbers(12, 1);
    LaneSum sum;
    for_each_in_lanes(1, 1 + count, [&]<class T>(Index j) {
      const T v = load<T>(numbers.data() + j);
      sum.add(v);
      store(T(v + 1.0), numbers.data() + j);
    });
    EXPECT_EQ(sum.total(), count);
    for (Index j = 0; j < 12; ++j) {
      EXPECT_EQ(numbers[static_cast<std::size_t>(j)], j >= 1 && j <= count ? 2 : 1);
    }
  }
}

TEST(Lanes, TheAlgebraOfQuaternionsIsThatOfEigen) {
  Random random(2);
  for (int k = 0; k < 100; ++k) {
    const Quat a = random_rotation(random), b = random_rotation(random);
    const Vec3 v = random_vector(random);
    EXPECT_LT((quat(quat_of(a) * quat_of(b)).coeffs() - (a * b).coeffs()).norm(), 1e-15);
    EXPECT_LT((vec3(quat_of(a) * triple(v)) - a * v).norm(), 2e-15);
    EXPECT_EQ(quat(quat_of(a).conjugate()).coeffs(), a.conjugate().coeffs());
  }
}

}  // namespace
}  // namespace wirepack
