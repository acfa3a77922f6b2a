#include "force_levels.hpp"

#include <cmath>

#include "wirepack/packing/mean_force.hpp"

namespace wirepack {

namespace {

std::optional<double> first_density(const std::vector<HistoryRow>& history, double force) {
  for (const HistoryRow& row : history) {
    if (row.force >= force) return row.packing_density;
  }
  return std::nullopt;
}

}  // namespace

std::vector<LevelDensity> level_densities(const Scenario& scenario,
                                          const std::vector<HistoryRow>& history) {
  const std::vector<MeanForce> means = mean_forces(scenario, history);
  std::vector<LevelDensity> levels;
  const auto add = [&](std::string_view scale, double unit) {
    for (int k = -6; k <= 12; ++k) {
      const double level = std::pow(10.0, k / 2.0);
      const std::optional<double> first = first_density(history, level * unit);
      if (!first) return;
      levels.push_back({scale, level, *first, density_at_force(means, level * unit)});
    }
  };
  add("scaled_force", units_of(scenario).scaled_force());
  add("force", units_of(scenario).force());
  return levels;
}

}  // namespace wirepack
