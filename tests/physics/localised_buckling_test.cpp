#include <gtest/gtest.h>

#include "../support/localised_helix.hpp"

namespace wirepack {
namespace {

using testing::localised_helix;
using testing::LocalisedHelix;

TEST(LocalisedBuckling, TorqueTensionAndEnvelopeAreThoseOfTheTwistedRodOfInfiniteLength) {
  // Waves of k = 0.5 along the wire: at N = 800 curvature that changes errs by (l k)^2 / 12 = 3e-4.
  // The tension at given slack takes up four times that (tests/convergence), the torque hardly any.
  const LocalisedHelix found = localised_helix(800);
  EXPECT_NEAR(found.moment / 1.3253831, 1, 1e-4);
  EXPECT_NEAR(found.tension / 0.3901836, 1, 2e-3);
  EXPECT_LT(found.envelope_error, 0.003);
}

TEST(LocalisedBuckling, ExactValuesSolveTheEquationsOfTheFiniteClampedRod) {
  constexpr double bend = 1.345, twist = 0.789, length = 100;
  const double m = 1.3253831 * length / bend;
  const double t = 0.3901836 * length * length / bend;
  EXPECT_NEAR(std::sqrt(16 / t * (1 - m * m / (4 * t))), 0.03, 1e-7);  // slack over length
  EXPECT_NEAR(m * bend / twist + 4 * std::acos(m / (2 * std::sqrt(t))), 27 * 2 * pi, 1e-4);
  const double c0 = m * m / (2 * t) - 1;
  EXPECT_NEAR(c0, testing::ExactEnvelope::c0, 1e-6);
  EXPECT_NEAR(2 * bend / 1.3253831 * std::sqrt((1 + c0) / (1 - c0)), testing::ExactEnvelope::width,
              1e-4);
}

}  // namespace
}  // namespace wirepack
