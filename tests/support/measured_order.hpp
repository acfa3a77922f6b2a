#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "wirepack/core/types.hpp"

namespace wirepack::testing {

/// Numbers of edges of a refinement study.
inline std::vector<Index> refinements() { return {25, 50, 100, 200}; }

/// Order p of error = c N^-p: slope of log(error) over log(N), least squares over all refinements.
inline double measured_order(const std::vector<Index>& edges, const std::vector<double>& errors) {
  const auto count = static_cast<double>(edges.size());
  double x_mean = 0, y_mean = 0;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    x_mean += std::log(static_cast<double>(edges[k])) / count;
    y_mean += std::log(errors[k]) / count;
  }
  double xy = 0, xx = 0;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const double x = std::log(static_cast<double>(edges[k])) - x_mean;
    xy += x * (std::log(errors[k]) - y_mean);
    xx += x * x;
  }
  return -xy / xx;
}

/// Errors of error_at(N) over the usual refinements and the order with which they fall.
struct Refinement {
  std::vector<double> errors;
  double order;
};

template <class ErrorAt>
Refinement refine(ErrorAt&& error_at) {
  Refinement result;
  for (const Index edges : refinements()) result.errors.push_back(error_at(edges));
  result.order = measured_order(refinements(), result.errors);
  return result;
}

}  // namespace wirepack::testing
