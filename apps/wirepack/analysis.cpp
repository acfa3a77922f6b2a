#include "analysis.hpp"

#include <cmath>
#include <map>
#include <set>

#include "wirepack/core/error.hpp"
#include "wirepack/io/config_file.hpp"

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

}  // namespace

std::vector<Ensemble> ensembles(const std::vector<AnalysedRun>& runs) {
  std::map<std::string, std::vector<std::size_t>> members;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    Scenario scenario = runs[k].scenario;
    scenario.seed = 0;
    members[resolved_config(scenario)].push_back(k);
  }
  std::vector<Ensemble> result;
  for (const auto& [config, of_config] : members) {
    std::set<std::uint64_t> seeds;
    for (const std::size_t k : of_config) seeds.insert(runs[k].scenario.seed);
    // the same run twice is no ensemble
    const bool different = seeds.size() == of_config.size();
    if (different && of_config.size() > 1) result.push_back(ensemble_of(runs, of_config));
  }
  return result;
}

std::vector<DensityLaw> density_laws(const std::vector<AnalysedRun>& runs) {
  std::vector<DensityLaw> laws;
  for (const Setup setup : {Setup::low_torsion, Setup::high_torsion}) {
    std::set<double> levels;
    for (const AnalysedRun& run : runs) {
      for (const LevelDensity& l : run.levels) {
        if (l.scale == "scaled_force" && l.mean) levels.insert(l.level);
      }
    }
    for (const double level : levels) {
      std::vector<double> ratio, density;
      for (const AnalysedRun& run : runs) {
        const LevelDensity* found = find_level(run, "scaled_force", level);
        if (run.scenario.setup != setup || found == nullptr || !found->mean) continue;
        ratio.push_back(run.scenario.wire.radius / run.scenario.cavity.radius);
        density.push_back(*found->mean);
      }
      if (ratio.size() < 3 || std::set<double>(ratio.begin(), ratio.end()).size() < 2) continue;
      laws.push_back({setup, level, ratio.size(), fit_power_law(ratio, density)});
    }
  }
  return laws;
}

}  // namespace wirepack
