#include "wirepack/dynamics/gear_values.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/core/types.hpp"

namespace wirepack {
namespace {

// x'' = -x from x = 1 at rest with exact initial derivatives.
GearValues oscillator(double step) {
  GearValues values(1, 6);
  double factor = 1;
  for (int k = 0; k < 6; ++k) {
    if (k > 0) factor *= step / k;
    values(0, k) = factor * std::cos(k * pi / 2);
  }
  return values;
}

void advance(GearValues& values, double step, std::int64_t count, const GearWeights& weights,
             double drag = 0) {
  for (std::int64_t k = 0; k < count; ++k) {
    gear_predict(values);
    const Eigen::VectorXd a = -values.col(0) - drag / step * values.col(1);
    gear_correct(values, a, step, weights);
  }
}

double error_at_10(std::int64_t count, const GearWeights& weights) {
  const double step = 10.0 / static_cast<double>(count);
  GearValues values = oscillator(step);
  advance(values, step, count, weights);
  return std::hypot(values(0, 0) - std::cos(10.0), values(0, 1) / step + std::sin(10.0));
}

double drift_of_100_periods(int steps_per_period, const GearWeights& weights) {
  const double step = 2 * pi / steps_per_period;
  GearValues values = oscillator(step);
  advance(values, step, 100 * steps_per_period, weights);
  return values(0, 0) * values(0, 0) + std::pow(values(0, 1) / step, 2) - 1;
}

// The errors are those of an independent computation (VALIDATION V5.1): to its four digits.
TEST(GearValues, ErrorOfAnOscillatorHasTheKnownValuesAndOrder5) {
  EXPECT_NEAR(error_at_10(200, gear_weights_velocity), 3.023e-8, 2e-11);
  EXPECT_NEAR(error_at_10(400, gear_weights_velocity), 9.104e-10, 2e-12);
  EXPECT_NEAR(error_at_10(800, gear_weights_velocity), 2.805e-11, 2e-13);
  EXPECT_NEAR(error_at_10(200, gear_weights_position), 1.058e-8, 1e-11);
  EXPECT_NEAR(error_at_10(400, gear_weights_position), 2.401e-10, 1e-12);
  EXPECT_NEAR(error_at_10(800, gear_weights_position), 6.122e-12, 2e-13);  // round-off shows
  const double order =
      std::log2(error_at_10(400, gear_weights_velocity) / error_at_10(800, gear_weights_velocity));
  EXPECT_NEAR(order, 5.0, 0.1);
}

// VALIDATION V5.2, to its four digits.
TEST(GearValues, EnergyOfAnOscillatorDriftsByTheKnownAmounts) {
  EXPECT_NEAR(drift_of_100_periods(50, gear_weights_position), 4.469e-5, 1e-8);
  EXPECT_NEAR(drift_of_100_periods(100, gear_weights_position), 3.525e-7, 1e-10);
  EXPECT_NEAR(drift_of_100_periods(50, gear_weights_velocity), -3.055e-4, 1e-7);
  EXPECT_NEAR(drift_of_100_periods(100, gear_weights_velocity), -1.103e-5, 1e-8);
}

// Growth of the amplitude per step, after the transient.
double growth_per_step(double frequency_times_step, double damping_ratio, int count = 500) {
  GearValues values = oscillator(1e-3);
  const double w = frequency_times_step;
  const auto steps = [&](int steps_to_take) {
    for (int k = 0; k < steps_to_take; ++k) {
      gear_predict(values);
      gear_correct(values, -w * w * values.col(0) - 2 * damping_ratio * w * values.col(1), 1);
    }
    return std::hypot(values(0, 0), values(0, 1) / w);
  };
  const double before = steps(count);
  return std::log(steps(count) / before) / count;
}

TEST(GearValues, AnUndampedOscillatorGrowsBeyondTheStatedLimitAtTheStatedRate) {
  EXPECT_LT(growth_per_step(gear_undamped_limit, 0, 20000), 1e-8);
  // logarithm of the spectral radius of the step, from its eigenvalues
  EXPECT_NEAR(growth_per_step(0.4, 0, 20000), 2.1336e-5, 1e-7);
  EXPECT_NEAR(growth_per_step(0.5, 0, 20000), 1.8537e-4, 1e-6);
}

TEST(GearValues, DampingStabilizesItOnlyWhileItIsSmall) {
  EXPECT_LT(growth_per_step(0.6, 0.01), 0);
  EXPECT_LT(growth_per_step(0.62, 0.05), 0);
  EXPECT_GT(growth_per_step(0.64, 0.05), 0);
  EXPECT_LT(growth_per_step(0.15, 0.5), 0);
  EXPECT_GT(growth_per_step(0.17, 0.5), 0);
}

TEST(GearValues, APolynomialOfDegreeFiveIsExact) {
  const double step = 0.1;
  GearValues values = GearValues::Zero(1, 6);
  values(0, 5) = std::pow(step, 5);  // x = t^5
  for (int k = 1; k <= 20; ++k) {
    gear_predict(values);
    gear_correct(values, Eigen::VectorXd::Constant(1, 20 * std::pow(k * step, 3)), step);
  }
  EXPECT_NEAR(values(0, 0), 32, 1e-12);  // round-off
}

}  // namespace
}  // namespace wirepack
