#include <gtest/gtest.h>

#include "../support/twisted_rods.hpp"

namespace wirepack {
namespace {

using testing::greenhill_torque;

// N = 100: (2 pi / N)^2 / 12 = 3e-4 for one full wave; under the tension 100 the waves are 3.5
// times shorter.
constexpr double tolerance = 2e-3;

TEST(Greenhill, HingedRodBucklesAtTheTorqueOfGreenhillUnderTension) {
  for (const double tension : {0.0, 10.0, 100.0}) {
    const double exact = 2 * std::sqrt(pi * pi + tension);
    EXPECT_NEAR(greenhill_torque(100, tension, false) / exact, 1, tolerance) << tension;
  }
}

TEST(Greenhill, ClampedRodBucklesAtTheComputedTorqueUnderTension) {
  struct Clamped {
    double tension, torque;
  };
  for (const Clamped& exact :
       {Clamped{0, 8.986819}, Clamped{10, 10.428856}, Clamped{100, 20.983501}}) {
    EXPECT_NEAR(greenhill_torque(100, exact.tension, true) / exact.torque, 1, tolerance)
        << exact.tension;
  }
}

}  // namespace
}  // namespace wirepack
