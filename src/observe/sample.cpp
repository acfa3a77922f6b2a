#include "wirepack/observe/sample.hpp"

#include <cmath>
#include <limits>

namespace wirepack {

double Sample::standard_error() const { return deviation / std::sqrt(static_cast<double>(count)); }

Sample sample(const std::vector<double>& values) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  Sample result{nothing, nothing, values.size()};
  const auto n = static_cast<double>(values.size());
  if (values.empty()) return result;
  double sum = 0, square = 0;
  for (const double value : values) sum += value;
  result.mean = sum / n;
  for (const double value : values) square += (value - result.mean) * (value - result.mean);
  if (values.size() > 1) result.deviation = std::sqrt(square / (n - 1));
  return result;
}

}  // namespace wirepack
