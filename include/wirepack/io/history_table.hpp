#pragma once

#include <string>

#include "wirepack/packing/history.hpp"
#include "wirepack/packing/packing_progress.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// The history of a run as aligned text, a line per increment. Forces are F R^2 / YI, energies
/// E R / YI, lengths over the wire radius a, which the header says.
class HistoryTable {
 public:
  explicit HistoryTable(const Scenario& scenario);
  /// Two lines, each starting with '#': names of the columns, and what they are scaled with.
  std::string header() const;
  std::string line(const HistoryRow& row, const PackingProgress& progress) const;

 private:
  double radius_;       // a
  double force_unit_;   // YI / R^2
  double energy_unit_;  // YI / R
};

}  // namespace wirepack
