#include "wirepack/core/arctangent.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/core/lanes.hpp"
#include "wirepack/core/random.hpp"

namespace wirepack {
namespace {

// Distance in units in the last place of the expected number.
double units_off(double value, double expected) {
  const double unit = std::nextafter(std::abs(expected), 10) - std::abs(expected);
  return std::abs(value - expected) / unit;
}

TEST(Arctangent, IsThatOfTheStandardLibraryToThreeUnitsInTheLastPlace) {
  Random random(1);
  double worst = 0;
  for (int k = 0; k < 200000; ++k) {
    // ratios from 1e-16 to 1e16, of both signs
    const double y = random.symmetric() * std::pow(10, 8 * random.symmetric());
    const double x = std::abs(random.symmetric()) * std::pow(10, 8 * random.symmetric());
    const double expected = std::atan2(y, x);
    worst = std::max(worst, units_off(arctangent(y, x), expected));
    const Lanes four = arctangent(Lanes(y), Lanes(x));
    worst = std::max(worst, units_off(four[k % lane_count], expected));
  }
  EXPECT_LT(worst, 3);
}

TEST(Arctangent, OfTheAxesAndOfTheBordersOfItsReductions) {
  EXPECT_EQ(arctangent(0.0, 1.0), 0);
  EXPECT_EQ(arctangent(2.0, 0.0), pi / 2);
  EXPECT_EQ(arctangent(-2.0, 0.0), -pi / 2);
  for (const double angle : {pi / 8, pi / 4, 3 * pi / 8}) {
    for (const double off : {-1e-15, 0.0, 1e-15}) {
      const double tangent = std::tan(angle) + off;
      EXPECT_LT(units_off(arctangent(tangent, 1.0), std::atan(tangent)), 3) << angle;
      EXPECT_LT(units_off(arctangent(-tangent, 1.0), -std::atan(tangent)), 3) << angle;
    }
  }
}

}  // namespace
}  // namespace wirepack
