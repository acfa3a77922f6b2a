#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wirepack/observe/power_law.hpp"

#include "force_levels.hpp"
#include "observed_frame.hpp"

namespace wirepack {

/// One result file.
struct AnalysedRun {
  std::string name;
  Scenario scenario;
  std::vector<LevelDensity> levels;
  std::vector<ObservedFrame> frames;  ///< the last one, or one to each density that was asked for
};

/// Runs that differ in their seeds alone: numbers over them.
struct Ensemble {
  std::vector<std::size_t> runs;                ///< two or more
  std::vector<std::vector<Sample>> quantities;  ///< of each frame that all runs have
  struct Level {
    std::string_view scale;
    double level;
    Sample first, mean;
  };
  std::vector<Level> levels;  ///< those that all runs reach; `mean` of those that have one
};
std::vector<Ensemble> ensembles(const std::vector<AnalysedRun>& runs);

/// phi_max at a level of F R^2 / YI (mean over an edge) against a / R, of the runs of a radius
/// series that have one.
struct DensityLaw {
  Setup setup;
  std::string first_run;  ///< of the series, to tell it from others of its setup
  double level;
  std::size_t runs;
  PowerLaw law;
};
/// At levels that three runs or more, with two different a / R at least, reach.
std::vector<DensityLaw> density_laws(const std::vector<AnalysedRun>& runs);

/// All of it as aligned text, JSON with all digits, or one line of comma-separated values a frame.
std::string analysis_table(const std::vector<AnalysedRun>& runs);
std::string analysis_json(const std::vector<AnalysedRun>& runs);
std::string analysis_csv(const std::vector<AnalysedRun>& runs);

}  // namespace wirepack
