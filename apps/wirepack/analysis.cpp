#include "analysis.hpp"

#include <cmath>
#include <set>

#include "wirepack/io/scenario_groups.hpp"

namespace wirepack {

namespace {

const LevelDensity* find_level(const AnalysedRun& run, std::string_view scale, double level) {
  for (const LevelDensity& found : run.levels) {
    if (found.scale == scale && found.level == level) return &found;
  }
  return nullptr;
}

Ensemble ensemble_of(const std::vector<AnalysedRun>& runs, std::vector<std::size_t> members) {
  Ensemble result{.runs = std::move(members), .quantities = {}, .levels = {}};
  std::size_t frames = runs[result.runs.front()].frames.size();
  for (const std::size_t k : result.runs) frames = std::min(frames, runs[k].frames.size());
  for (std::size_t f = 0; f < frames; ++f) {
    std::vector<Sample>& row = result.quantities.emplace_back();
    for (const Quantity& quantity : frame_quantities()) {
      std::vector<double> values;
      for (const std::size_t k : result.runs) values.push_back(quantity.of(runs[k].frames[f]));
      row.push_back(sample(values));
    }
  }
  for (const LevelDensity& level : runs[result.runs.front()].levels) {
    std::vector<double> first, mean;
    for (const std::size_t k : result.runs) {
      const LevelDensity* found = find_level(runs[k], level.scale, level.level);
      if (found != nullptr) first.push_back(found->first);
      if (found != nullptr && found->mean) mean.push_back(*found->mean);
    }
    if (first.size() < result.runs.size()) continue;
    result.levels.push_back({level.scale, level.level, sample(first), sample(mean)});
  }
  return result;
}

std::vector<Scenario> scenarios_of(const std::vector<AnalysedRun>& runs) {
  std::vector<Scenario> scenarios;
  for (const AnalysedRun& run : runs) scenarios.push_back(run.scenario);
  return scenarios;
}

}  // namespace

std::vector<Ensemble> ensembles(const std::vector<AnalysedRun>& runs) {
  std::vector<Ensemble> result;
  for (const std::vector<std::size_t>& members : seed_groups(scenarios_of(runs))) {
    if (members.size() > 1) result.push_back(ensemble_of(runs, members));
  }
  return result;
}

std::vector<DensityLaw> density_laws(const std::vector<AnalysedRun>& runs) {
  std::vector<DensityLaw> laws;
  for (const std::vector<std::size_t>& series : radius_series(scenarios_of(runs))) {
    std::set<double> levels;
    for (const std::size_t k : series) {
      for (const LevelDensity& l : runs[k].levels) {
        if (l.scale == "scaled_force" && l.mean) levels.insert(l.level);
      }
    }
    for (const double level : levels) {
      std::vector<double> ratio, density;
      for (const std::size_t k : series) {
        const LevelDensity* found = find_level(runs[k], "scaled_force", level);
        if (found == nullptr || !found->mean) continue;
        ratio.push_back(runs[k].scenario.wire.radius / runs[k].scenario.cavity.radius);
        density.push_back(*found->mean);
      }
      if (ratio.size() < 3 || std::set<double>(ratio.begin(), ratio.end()).size() < 2) continue;
      laws.push_back({runs[series.front()].scenario.setup, runs[series.front()].name, level,
                      ratio.size(), fit_power_law(ratio, density)});
    }
  }
  return laws;
}

}  // namespace wirepack
