#pragma once

#include <span>
#include <vector>

namespace wirepack {

/// Log-normal law of positive values x: the logarithms are normal with mean mu and deviation sigma.
struct LogNormalFit {
  double mu = 0, sigma = 0;
  double mu_error = 0, sigma_error = 0;  ///< sigma / sqrt n and sigma / sqrt(2 n), Cramer-Rao
  double mean = 0;                       ///< of the values; 1 if they were divided by it
  double ks_distance = 0;  ///< largest difference of cumulated distributions (Kolmogorov-Smirnov)
  int count = 0;           ///< of the values above zero, which are what is fitted

  double fitted_mean() const;  ///< exp(mu + sigma^2 / 2)
};

/// Maximum likelihood: mean and deviation (divided by n) of the logarithms. Values that are not
/// above zero are left out. All zero when fewer than two are left.
LogNormalFit fit_log_normal(std::span<const double> values);

/// Values above zero over their mean, in rising order.
std::vector<double> over_mean(std::span<const double> values);

/// Of values over their mean; as the paper shows E_b / <E_b>.
LogNormalFit fit_log_normal_over_mean(std::span<const double> values);

}  // namespace wirepack
