#pragma once

#include <array>

#include "wirepack/core/lanes.hpp"
#include "wirepack/core/types.hpp"

namespace wirepack {

/// Second derivative, at x, of a function whose gradient is known for numbers in lanes:
/// `gradient` takes and returns a std::array<Lanes, n>. By central differences, `step` each way.
template <int n, class Gradient>
Eigen::Matrix<double, n, n> second_derivative(const std::array<double, n>& x, double step,
                                              Gradient&& gradient) {
  using Point = std::array<Lanes, n>;
  Eigen::Matrix<double, n, n> result;
  for (int first = 0; first < n; first += lane_count) {
    const auto moved_by = [&](double move) {
      Point p;
      for (int k = 0; k < n; ++k) {
        const auto i = static_cast<std::size_t>(k);
        p[i] = lanes_of([&](int lane) { return k == first + lane ? x[i] + move : x[i]; });
      }
      return gradient(p);
    };
    const Point up = moved_by(step), down = moved_by(-step);
    for (int k = 0; k < n; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const Lanes slope = (up[i] - down[i]) / (2 * step);
      for (int lane = 0; lane < lane_count && first + lane < n; ++lane) {
        result(k, first + lane) = slope[static_cast<std::size_t>(lane)];
      }
    }
  }
  return (0.5 * (result + result.transpose())).eval();
}

}  // namespace wirepack
