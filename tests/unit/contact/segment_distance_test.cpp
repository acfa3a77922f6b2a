#include "wirepack/contact/segment_distance.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "../../support/sample_rods.hpp"

namespace wirepack {
namespace {

using testing::random_vector;

// The distance is convex along one segment when the other is projected on exactly, so a search by
// thirds over one of them finds it; independent of the closed form under test.
double searched_distance(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
  const auto from = [&](double s) {
    const Vec3 p = p0 + s * (p1 - p0);
    const Vec3 d = q1 - q0;
    const double dd = d.squaredNorm();
    const double t = dd > 0 ? std::clamp((p - q0).dot(d) / dd, 0.0, 1.0) : 0.0;
    return (p - q0 - t * d).norm();
  };
  double low = 0, high = 1;
  for (int k = 0; k < 200; ++k) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (from(a) < from(b) ? high : low) = from(a) < from(b) ? b : a;
  }
  return from((low + high) / 2);
}

void expect_distance(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
  const double found = std::sqrt(squared_segment_distance(p0, p1, q0, q1));
  // the search resolves the flat bottom of a distance to the root of rounding
  EXPECT_NEAR(found, searched_distance(p0, p1, q0, q1), 1e-7);
  EXPECT_NEAR(found, std::sqrt(squared_segment_distance(q1, q0, p0, p1)), 1e-12);  // symmetric
}

TEST(SegmentDistance, AgreesWithASearchForRandomSegments) {
  Random random(31);
  for (int k = 0; k < 2000; ++k) {
    expect_distance(random_vector(random), random_vector(random), random_vector(random),
                    random_vector(random));
  }
}

TEST(SegmentDistance, AgreesWithASearchForParallelAndNearlyParallelSegments) {
  Random random(32);
  for (const double turn : {0.0, 1e-12, 1e-8, 1e-4}) {
    for (int k = 0; k < 300; ++k) {
      const Vec3 p0 = random_vector(random), e = random_vector(random), q0 = random_vector(random);
      expect_distance(p0, p0 + e, q0, q0 + 2 * random.symmetric() * (e + turn * q0));
    }
  }
}

TEST(SegmentDistance, TakesSegmentsWithoutLengthAsPoints) {
  const Vec3 p(1, 2, 3), q0(0, 0, 0), q1(2, 0, 0);
  EXPECT_DOUBLE_EQ(squared_segment_distance(p, p, q0, q1), 13);
  EXPECT_DOUBLE_EQ(squared_segment_distance(q0, q1, p, p), 13);
  EXPECT_DOUBLE_EQ(squared_segment_distance(p, p, q1, q1), 14);
}

TEST(SegmentDistance, OfCrossingAndOverlappingSegmentsIsZero) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY();
  EXPECT_EQ(squared_segment_distance(-x, x, -y, y), 0);
  EXPECT_EQ(squared_segment_distance(-x, x, Vec3::Zero(), 3 * x), 0);
  EXPECT_DOUBLE_EQ(squared_segment_distance(-x, x, 3 * x, 4 * x), 4);  // in line, end to end
}

}  // namespace
}  // namespace wirepack
