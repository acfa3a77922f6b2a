#include "coded_field.hpp"

#include <algorithm>
#include <cmath>

namespace wirepack {

namespace {

// Values over their natural unit that are round-off and not worth a colour.
constexpr double smallest_shown = 1e-6;

double quantile(std::vector<double>& values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

}  // namespace

ByteScale byte_scale(const std::vector<Eigen::VectorXd>& values, bool logarithmic) {
  std::vector<double> shown;
  double low = INFINITY, high = -INFINITY;
  for (const Eigen::VectorXd& list : values) {
    for (const double value : list) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
      if (!logarithmic || value > smallest_shown) shown.push_back(value);
    }
  }
  if (logarithmic) {
    high = std::max(high, 10 * smallest_shown);
    low = std::max(1e-4 * high, smallest_shown);
  } else if (!(low < high)) {
    low = std::isfinite(low) ? low : 0;
    high = low + 1;
  }
  ByteScale scale{low, high, logarithmic, low, high};
  if (shown.empty()) return scale;
  scale.shown_low = std::max(low, quantile(shown, 0.02));
  scale.shown_high = std::min(high, quantile(shown, 0.995));
  if (!(scale.shown_low < scale.shown_high)) {
    scale.shown_low = low;
    scale.shown_high = high;
  }
  return scale;
}

std::vector<unsigned char> bytes_of(const Eigen::VectorXd& values, const ByteScale& scale) {
  std::vector<unsigned char> bytes(static_cast<std::size_t>(values.size()), 0);
  for (Index i = 0; i < values.size(); ++i) {
    const double value = values[i];
    if (!(value >= scale.low)) continue;
    const double share = scale.logarithmic
                             ? std::log(value / scale.low) / std::log(scale.high / scale.low)
                             : (value - scale.low) / (scale.high - scale.low);
    const double code = 1 + std::round(254 * std::min(share, 1.0));
    bytes[static_cast<std::size_t>(i)] = static_cast<unsigned char>(code);
  }
  return bytes;
}

}  // namespace wirepack
