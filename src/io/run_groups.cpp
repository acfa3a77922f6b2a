#include "run_groups.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>
#include <optional>

#include "wirepack/io/scenario_groups.hpp"

#include "setup_name.hpp"

namespace wirepack {

namespace {

constexpr int densities = 200;

std::array<double, 3> scaled(const FigureRun& run, const HistoryRow& row) {
  const double unit = units_of(run.scenario).scaled_energy();
  return {row.scaled_force, row.energy_bend / unit, row.energy_twist / unit};
}

CurvePoint point_of(double density, const std::vector<std::array<double, 3>>& values) {
  std::array<Sample, 3> samples;
  for (std::size_t q = 0; q < 3; ++q) {
    std::vector<double> of_quantity;
    for (const auto& value : values) of_quantity.push_back(value[q]);
    samples[q] = sample(of_quantity);
  }
  return {density, samples[0], samples[1], samples[2]};
}

// Between the rows around a density; nothing beyond the last one.
std::optional<std::array<double, 3>> at_density(const FigureRun& run, double density) {
  const auto after = std::lower_bound(
      run.history.begin(), run.history.end(), density,
      [](const HistoryRow& row, double value) { return row.packing_density < value; });
  if (after == run.history.end() || after == run.history.begin()) return std::nullopt;
  const HistoryRow& before = *(after - 1);
  const double share =
      (density - before.packing_density) / (after->packing_density - before.packing_density);
  const auto low = scaled(run, before), high = scaled(run, *after);
  std::array<double, 3> value;
  for (std::size_t q = 0; q < 3; ++q) value[q] = low[q] + share * (high[q] - low[q]);
  return value;
}

std::vector<CurvePoint> points_of(const std::vector<const FigureRun*>& runs) {
  std::vector<CurvePoint> points;
  if (runs.size() == 1) {
    for (const HistoryRow& row : runs.front()->history) {
      points.push_back(point_of(row.packing_density, {scaled(*runs.front(), row)}));
    }
    return points;
  }
  double last = 0;
  for (const FigureRun* run : runs) last = std::max(last, run->history.back().packing_density);
  for (int k = 1; k <= densities; ++k) {
    const double density = last * k / densities;
    std::vector<std::array<double, 3>> values;
    for (const FigureRun* run : runs) {
      if (const auto value = at_density(*run, density)) values.push_back(*value);
    }
    if (values.size() > 1) points.push_back(point_of(density, values));
  }
  return points;
}

// A group of seeds is called by what makes the packing, and by its first run where that is not
// enough.
void name_groups(std::vector<RunGroup>& groups) {
  std::map<std::string, int> uses;
  const auto name = [](const RunGroup& group) {
    const Scenario& scenario = group.runs.front()->scenario;
    return fmt::format("{}, R = {:.3g} a, {} seeds", setup_name(scenario.setup),
                       scenario.cavity.radius / scenario.wire.radius, group.runs.size());
  };
  for (const RunGroup& group : groups) ++uses[name(group)];
  for (RunGroup& group : groups) {
    if (group.runs.size() == 1) continue;
    const std::string common = name(group);
    group.label = uses[common] == 1 ? common : fmt::format("{} ({})", common, group.label);
  }
}

}  // namespace

std::vector<RunGroup> run_groups(const std::vector<FigureRun>& runs) {
  std::vector<Scenario> scenarios;
  for (const FigureRun& run : runs) scenarios.push_back(run.scenario);
  std::vector<RunGroup> groups;
  for (const std::vector<std::size_t>& members : seed_groups(scenarios)) {
    RunGroup& group = groups.emplace_back(RunGroup{runs[members.front()].label, {}, {}});
    for (const std::size_t k : members) group.runs.push_back(&runs[k]);
    group.points = points_of(group.runs);
  }
  name_groups(groups);
  return groups;
}

}  // namespace wirepack
