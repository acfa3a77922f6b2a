#pragma once

#include <vector>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// How the values of a field, over all frames, become bytes: 1 ... 255 from `low` to `high` on a
/// linear or a logarithmic scale, which is a step of 3.7 % then; 0 below `low`.
struct ByteScale {
  double low, high;
  bool logarithmic;
  /// From the values that a colour bar should span: all but the few extreme ones.
  double shown_low, shown_high;
};

/// The scale that holds all of `values`: a logarithmic one the four decades below the largest.
ByteScale byte_scale(const std::vector<Eigen::VectorXd>& values, bool logarithmic);

std::vector<unsigned char> bytes_of(const Eigen::VectorXd& values, const ByteScale& scale);

}  // namespace wirepack
