#pragma once

#include <cstddef>
#include <vector>

namespace wirepack {

/// Mean and standard deviation of a sample.
struct Sample {
  double mean = 0, deviation = 0;
  std::size_t count = 0;

  /// Of the mean: deviation / sqrt(count); not a number where there is one value.
  double standard_error() const;
};
/// Not-a-numbers where there are too few values.
Sample sample(const std::vector<double>& values);

}  // namespace wirepack
