#include "force_levels.hpp"

#include <cmath>

#include "wirepack/packing/mean_force.hpp"

namespace wirepack {

namespace {

struct MeanReading {
  double packing_density, force;
};

std::vector<MeanReading> mean_readings(const Scenario& scenario,
                                       const std::vector<HistoryRow>& history) {
  std::vector<MeanReading> means;
  std::vector<ForceReading> recent;
  const double edge_length = scenario.wire.edge_length;
  for (const HistoryRow& row : history) {
    note_force(edge_length, row, recent);
    const std::optional<double> mean = mean_force(edge_length, recent);
    if (mean) means.push_back({row.packing_density, *mean});
  }
  return means;
}

template <class Readings>
std::optional<double> first_density(const Readings& readings, double force) {
  for (const auto& reading : readings) {
    if (reading.force >= force) return reading.packing_density;
  }
  return std::nullopt;
}

}  // namespace

std::vector<LevelDensity> level_densities(const Scenario& scenario,
                                          const std::vector<HistoryRow>& history) {
  const std::vector<MeanReading> means = mean_readings(scenario, history);
  std::vector<LevelDensity> levels;
  const auto add = [&](std::string_view scale, double unit) {
    for (int k = -6; k <= 12; ++k) {
      const double level = std::pow(10.0, k / 2.0);
      const std::optional<double> first = first_density(history, level * unit);
      if (!first) return;
      levels.push_back({scale, level, *first, first_density(means, level * unit)});
    }
  };
  add("scaled_force", units_of(scenario).scaled_force());
  add("force", units_of(scenario).force());
  return levels;
}

}  // namespace wirepack
