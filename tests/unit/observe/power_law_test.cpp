#include "wirepack/observe/power_law.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "wirepack/core/error.hpp"
#include "wirepack/core/random.hpp"

namespace wirepack {
namespace {

TEST(PowerLaw, of_exact_points_is_exact_and_without_error) {
  const std::vector<double> x{0.02, 0.05, 0.1, 0.25};
  std::vector<double> y;
  for (const double value : x) y.push_back(0.982 * std::pow(value, 0.38));
  const PowerLaw law = fit_power_law(x, y);
  EXPECT_NEAR(law.exponent, 0.38, 1e-12);
  EXPECT_NEAR(law.factor, 0.982, 1e-12);
  EXPECT_LT(law.exponent_error, 1e-12);
}

TEST(PowerLaw, bootstrap_error_is_the_scatter_of_fits_to_new_data) {
  Random random(3);
  const int trials = 300;
  double square = 0, claimed = 0;
  for (int k = 0; k < trials; ++k) {
    std::vector<double> x, y;
    for (int run = 0; run < 36; ++run) {
      x.push_back(std::pow(2.0, -1 - run % 6));
      // a sum of uniform numbers with the deviation 0.1
      const double noise = 0.1 * (random.symmetric() + random.symmetric() + random.symmetric());
      y.push_back(std::pow(x.back(), 0.4) * std::exp(noise));
    }
    const PowerLaw law = fit_power_law(x, y, 1, 300);
    square += std::pow(law.exponent - 0.4, 2) / trials;
    claimed += law.exponent_error / trials;
  }
  // 300 trials know the scatter to 4 %; samples of 36 points lose some 3 %
  EXPECT_NEAR(claimed / std::sqrt(square), 1, 0.15);
}

TEST(PowerLaw, of_one_place_or_of_a_zero_is_refused) {
  EXPECT_THROW(fit_power_law(std::vector<double>{0.1, 0.1}, std::vector<double>{1, 2}),
               InvalidInput);
  EXPECT_THROW(fit_power_law(std::vector<double>{0.1, 0.2}, std::vector<double>{0, 2}),
               InvalidInput);
}

}  // namespace
}  // namespace wirepack
