#pragma once

#include <cmath>

namespace wirepack {

/// A value as it is shown: 0 where it is no more than the round-off of what it is a part of.
inline double without_round_off(double value, double whole) {
  return std::abs(value) <= 1e-14 * std::abs(whole) ? 0 : value;
}

}  // namespace wirepack
