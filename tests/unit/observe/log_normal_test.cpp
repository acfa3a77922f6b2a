#include "wirepack/observe/log_normal.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "wirepack/core/random.hpp"
#include "wirepack/core/types.hpp"

namespace wirepack {
namespace {

std::vector<double> log_normal_numbers(double mu, double sigma, int count, Random& random) {
  std::vector<double> values;
  const auto uniform = [&] { return (random.symmetric() + 1) / 2; };
  while (static_cast<int>(values.size()) < count) {  // Box & Muller 1958
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    values.push_back(std::exp(mu + sigma * radius * std::cos(2 * pi * uniform())));
  }
  return values;
}

TEST(LogNormal, fit_of_synthetic_data_scatters_as_cramer_and_rao_allow) {
  Random random(5);
  const double mu = -0.903, sigma = 1.275;  // of the paper
  const int trials = 2000, count = 400;
  double square_mu = 0, square_sigma = 0, error_mu = 0, error_sigma = 0;
  for (int k = 0; k < trials; ++k) {
    const LogNormalFit fit = fit_log_normal(log_normal_numbers(mu, sigma, count, random));
    square_mu += std::pow(fit.mu - mu, 2) / trials;
    square_sigma += std::pow(fit.sigma - sigma, 2) / trials;
    error_mu += fit.mu_error / trials;
    error_sigma += fit.sigma_error / trials;
  }
  // deviations over 2000 trials are known to 1.6 %; 7 % is four times that
  const double bound_mu = sigma / std::sqrt(count), bound_sigma = sigma / std::sqrt(2.0 * count);
  EXPECT_NEAR(std::sqrt(square_mu), bound_mu, 0.07 * bound_mu);
  EXPECT_NEAR(std::sqrt(square_sigma), bound_sigma, 0.07 * bound_sigma);
  EXPECT_NEAR(error_mu, bound_mu, 0.01 * bound_mu);
  EXPECT_NEAR(error_sigma, bound_sigma, 0.01 * bound_sigma);
}

TEST(LogNormal,
     ks_distance_is_small_for_the_law_and_large_for_equal_energies_with_a_few_high_ones) {
  Random random(6);
  std::vector<double> values = log_normal_numbers(0.3, 0.8, 10000, random);
  const LogNormalFit law = fit_log_normal(values);
  EXPECT_LT(law.ks_distance, 1.36 / 100);  // 5 % level of n = 10^4
  EXPECT_GT(law.ks_distance, 0.2 / 100);
  for (std::size_t k = 0; k < 9000; ++k) values[k] = 0.1 + 1e-6 * static_cast<double>(k);
  EXPECT_GT(fit_log_normal(values).ks_distance, 0.2);
}

TEST(LogNormal, values_over_their_mean_have_mean_one_and_zeros_are_left_out) {
  const LogNormalFit fit = fit_log_normal_over_mean(std::vector<double>{0, 1, 3, 8});
  EXPECT_EQ(fit.count, 3);
  EXPECT_NEAR(fit.mean, 1, 1e-15);
  EXPECT_NEAR(fit.mu, std::log(24.0) / 3 - std::log(4.0), 1e-14);
  EXPECT_NEAR(LogNormalFit({.mu = -0.903, .sigma = 1.275}).fitted_mean(), 0.914, 5e-4);
}

}  // namespace
}  // namespace wirepack
