#include "wirepack/packing/run_totals.hpp"

#include <algorithm>

namespace wirepack {

void RunTotals::add(const HistoryRow& row) {
  largest_residual = std::max(largest_residual, row.residual);
  largest_overlap = std::max(largest_overlap, row.max_overlap);
  kinetic += row.energy_kinetic;
  stored += row.energy_total;
  seconds = row.wall_seconds;
}

RunTotals totals_of(const std::vector<HistoryRow>& history, double last_increment) {
  RunTotals totals;
  for (const HistoryRow& row : history) {
    if (row.increment <= last_increment) totals.add(row);
  }
  return totals;
}

}  // namespace wirepack
