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
  std::set<double> levels;
  for (const AnalysedRun& run : runs) {
    for (const LevelDensity& l : run.levels) {
      if (l.scale == "scaled_force" && l.mean) levels.insert(l.level);
    }
  }
  std::vector<DensityLaw> laws;
  for (const double level : levels) {
    std::vector<Scenario> scenarios;  // of the runs that reach the level
    std::vector<const AnalysedRun*> reaching;
    std::vector<double> density;
    for (const AnalysedRun& run : runs) {
      const LevelDensity* found = find_level(run, "scaled_force", level);
      if (found == nullptr || !found->mean) continue;
      scenarios.push_back(run.scenario);
      reaching.push_back(&run);
      density.push_back(*found->mean);
    }
    for (const std::vector<std::size_t>& series : radius_series(scenarios)) {
      std::vector<double> ratio_of_series, density_of_series;
      for (const std::size_t k : series) {
        ratio_of_series.push_back(scenarios[k].wire.radius / scenarios[k].cavity.radius);
        density_of_series.push_back(density[k]);
      }
      const std::set<double> ratios(ratio_of_series.begin(), ratio_of_series.end());
      if (series.size() < 3 || ratios.size() < 2) continue;
      const AnalysedRun& first = *reaching[series.front()];
      laws.push_back({first.scenario.setup, first.name, level, series.size(),
                      fit_power_law(ratio_of_series, density_of_series)});
    }
  }
  return laws;
}

}  // namespace wirepack
