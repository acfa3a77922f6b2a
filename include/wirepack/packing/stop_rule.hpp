#pragma once

#include <optional>
#include <string_view>

#include "wirepack/packing/packing_progress.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// Why a run ended: one of the limits of the scenario, or a failure.
enum class StopReason {
  scaled_force,
  force,
  density,
  length,
  increments,
  no_equilibrium,  ///< no minimum found, even in the smallest substep
  strands_passed,  ///< strands pass through each other even in the smallest substep
};
std::string_view name_of(StopReason reason);

/// The limit of the scenario that a run has reached with this row, if any. Limits of the force ask
/// for `force`, the mean over the last edge length of wire; nothing: it is not known yet.
std::optional<StopReason> reached_limit(const Scenario& scenario, const HistoryRow& row,
                                        std::optional<double> force);
/// The same of the last row.
std::optional<StopReason> reached_limit(const Scenario& scenario, const PackingProgress& progress);

/// `length`, or less where that would pass stop.length or stop.density behind the wire that is
/// inside.
double length_within_limits(const Scenario& scenario, double inserted_length, double length);

}  // namespace wirepack
