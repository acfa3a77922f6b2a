#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "wirepack/packing/history.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// The densities at which a run's injection force first reaches a level; phi_max at this threshold.
struct LevelDensity {
  std::string_view scale;  ///< "scaled_force" (F R^2 / YI) or "force" (F / (Y a^2))
  double level;            ///< decades and half-decades
  double first;            ///< where a row is the first above it: a peak of the mesh will do
  /// where the mean over the last edge length of wire fed is, after the first coil; nothing when
  /// that stays below
  std::optional<double> mean;
};

/// Every level that some row reaches, in order.
std::vector<LevelDensity> level_densities(const Scenario& scenario,
                                          const std::vector<HistoryRow>& history);

}  // namespace wirepack
