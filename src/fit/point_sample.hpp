#pragma once

#include <algorithm>
#include <vector>

#include "wirepack/core/random.hpp"
#include "wirepack/core/types.hpp"

namespace wirepack {

/// So many places of a list at most, in their order, one drawn from each of as many equal parts.
/// Equal strides through the points of a coil could all lie on another one.
inline std::vector<Index> point_sample(Index count, Index most) {
  Random random(1);
  std::vector<Index> which;
  const Index used = std::min(count, most);
  for (Index k = 0; k < used; ++k) {
    const Index first = k * count / used, next = (k + 1) * count / used;
    const auto size = static_cast<std::uint64_t>(next - first);
    which.push_back(first + static_cast<Index>(random.next() % size));
  }
  return which;
}

}  // namespace wirepack
