#pragma once

#include <vector>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// first, first + 1, ...: so many.
std::vector<Index> consecutive(Index first, Index count);

/// Places of values, the smallest first; equal ones as they come.
std::vector<Index> order_by(const Eigen::VectorXd& values);

/// Those members of a list that stand at places of it, in the order of the places.
std::vector<Index> picked(const std::vector<Index>& list, const std::vector<Index>& places);

/// 0 to count - 1 without those of a sorted list.
std::vector<Index> all_without(Index count, const std::vector<Index>& sorted);

}  // namespace wirepack
