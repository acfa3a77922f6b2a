#include "wirepack/packing/stop_rule.hpp"

#include <algorithm>

#include "wirepack/observe/packing_density.hpp"

namespace wirepack {

std::string_view name_of(StopReason reason) {
  switch (reason) {
    case StopReason::scaled_force:
      return "scaled_force";
    case StopReason::force:
      return "force";
    case StopReason::density:
      return "density";
    case StopReason::length:
      return "length";
    case StopReason::increments:
      return "increments";
    case StopReason::no_equilibrium:
      return "no_equilibrium";
    case StopReason::strands_passed:
      return "strands_passed";
  }
  return "unknown";
}

std::optional<StopReason> reached_limit(const Scenario& scenario, const HistoryRow& row,
                                        std::optional<double> force) {
  const StopLimits& stop = scenario.stop;
  // lengths are sums of increments: a limit is reached to round-off
  const auto reached = [](double value, const auto& limit) {
    return limit && value >= static_cast<double>(*limit) * (1 - 1e-12);
  };
  if (force) {
    const Units units = units_of(scenario);
    if (reached(*force / units.scaled_force(), stop.scaled_force)) return StopReason::scaled_force;
    if (reached(*force / units.force(), stop.force)) return StopReason::force;
  }
  if (reached(row.packing_density, stop.density)) return StopReason::density;
  if (reached(row.inserted_length, stop.length)) return StopReason::length;
  if (reached(row.increment, stop.increments)) return StopReason::increments;
  return std::nullopt;
}

std::optional<StopReason> reached_limit(const Scenario& scenario, const PackingProgress& progress) {
  return reached_limit(scenario, progress.last,
                       mean_force(scenario.wire.edge_length, progress.recent_forces));
}

double length_within_limits(const Scenario& scenario, double inserted_length, double length) {
  const StopLimits& stop = scenario.stop;
  if (stop.length) length = std::min(length, *stop.length - inserted_length);
  if (stop.density) {
    const double end = length_at_density(*stop.density, scenario.cavity, scenario.wire.radius);
    length = std::min(length, end - inserted_length);
  }
  return length;
}

}  // namespace wirepack
