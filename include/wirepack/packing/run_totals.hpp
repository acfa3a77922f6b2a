#pragma once

#include <vector>

#include "wirepack/packing/history.hpp"

namespace wirepack {

/// What a run amounts to so far; can be gathered from a saved history.
struct RunTotals {
  double largest_residual = 0;
  double largest_overlap = 0;
  double kinetic = 0, stored = 0;  ///< energies, summed over increments
  double seconds = 0;
  void add(const HistoryRow& row);
};

/// Of the rows up to an increment.
RunTotals totals_of(const std::vector<HistoryRow>& history, double last_increment);

}  // namespace wirepack
