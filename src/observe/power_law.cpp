#include "wirepack/observe/power_law.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "wirepack/core/error.hpp"
#include "wirepack/core/random.hpp"
#include "wirepack/observe/sample.hpp"

namespace wirepack {

namespace {

struct Line {
  double slope, start;
};

Line least_squares(const std::vector<double>& x, const std::vector<double>& y) {
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  const auto n = static_cast<double>(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    mean_x += x[k] / n;
    mean_y += y[k] / n;
  }
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mean_x) * (x[k] - mean_x);
    xy += (x[k] - mean_x) * (y[k] - mean_y);
  }
  return {xy / xx, mean_y - xy / xx * mean_x};
}

bool all_equal(const std::vector<double>& x) {
  return std::all_of(x.begin(), x.end(), [&](double value) { return value == x.front(); });
}

}  // namespace

PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y, std::uint64_t seed,
                       int samples) {
  const auto is_positive = [](double value) { return value > 0; };
  if (x.size() != y.size() || !std::all_of(x.begin(), x.end(), is_positive) ||
      !std::all_of(y.begin(), y.end(), is_positive)) {
    throw InvalidInput("a power law needs pairs of numbers above zero");
  }
  std::vector<double> log_x, log_y;
  for (const double value : x) log_x.push_back(std::log(value));
  for (const double value : y) log_y.push_back(std::log(value));
  if (log_x.size() < 2 || all_equal(log_x)) {
    throw InvalidInput("a power law needs two different places at least");
  }
  Random random(seed);
  std::vector<double> exponents, factors, sample_x(x.size()), sample_y(x.size());
  while (exponents.size() < static_cast<std::size_t>(samples)) {
    for (std::size_t k = 0; k < x.size(); ++k) {
      const std::size_t drawn = random.next() % x.size();
      sample_x[k] = log_x[drawn];
      sample_y[k] = log_y[drawn];
    }
    if (all_equal(sample_x)) continue;
    const Line line = least_squares(sample_x, sample_y);
    exponents.push_back(line.slope);
    factors.push_back(std::exp(line.start));
  }
  const Line line = least_squares(log_x, log_y);
  return {line.slope, sample(exponents).deviation, std::exp(line.start), sample(factors).deviation};
}

}  // namespace wirepack
