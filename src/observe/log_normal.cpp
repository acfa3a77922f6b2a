#include "wirepack/observe/log_normal.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace wirepack {

namespace {

std::vector<double> positive(std::span<const double> values) {
  std::vector<double> result;
  std::copy_if(values.begin(), values.end(), std::back_inserter(result),
               [](double x) { return x > 0; });
  std::sort(result.begin(), result.end());
  return result;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double ks_distance(const std::vector<double>& sorted, double mu, double sigma) {
  const auto n = static_cast<double>(sorted.size());
  double largest = 0;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const double law = std::erfc((mu - std::log(sorted[k])) / (sigma * std::sqrt(2.0))) / 2;
    const auto before = static_cast<double>(k);
    largest = std::max({largest, law - before / n, (before + 1) / n - law});
  }
  return largest;
}

}  // namespace

double LogNormalFit::fitted_mean() const { return std::exp(mu + sigma * sigma / 2); }

LogNormalFit fit_log_normal(std::span<const double> values) {
  const std::vector<double> sorted = positive(values);
  LogNormalFit fit;
  if (sorted.size() < 2) return fit;
  const auto n = static_cast<double>(sorted.size());
  for (const double x : sorted) fit.mu += std::log(x) / n;
  double variance = 0;
  for (const double x : sorted) variance += std::pow(std::log(x) - fit.mu, 2) / n;
  fit.sigma = std::sqrt(variance);
  fit.mu_error = fit.sigma / std::sqrt(n);
  fit.sigma_error = fit.sigma / std::sqrt(2 * n);
  fit.mean = mean_of(sorted);
  fit.ks_distance = fit.sigma > 0 ? ks_distance(sorted, fit.mu, fit.sigma) : 0;
  fit.count = static_cast<int>(sorted.size());
  return fit;
}

std::vector<double> over_mean(std::span<const double> values) {
  std::vector<double> scaled = positive(values);
  const double mean = mean_of(scaled);
  for (double& x : scaled) x /= mean;
  return scaled;
}

LogNormalFit fit_log_normal_over_mean(std::span<const double> values) {
  return fit_log_normal(over_mean(values));
}

}  // namespace wirepack
