#pragma once

#include <cstdio>
#include <optional>
#include <string>

#include "wirepack/io/hdf5_recorder.hpp"
#include "wirepack/packing/packing_run.hpp"

namespace wirepack {

/// What a run amounts to so far; can be gathered from a saved history.
struct RunTotals {
  double largest_residual = 0;
  double largest_overlap = 0;
  double kinetic = 0, stored = 0;  ///< energies, summed over increments
  double seconds = 0;
  void add(const HistoryRow& row);
};

struct RunResult {
  std::optional<StopReason> stop;  ///< nothing: a signal stopped the run
  RunTotals totals;
};

/// Runs until a limit or a stop signal: prints the table, if one is wanted, and progress to stderr (on a
/// terminal), and brings everything to the file at the start, with every frame, every
/// output.checkpoint_every_seconds, and at the end. Throws NumericalFailure, with all increments
/// before it saved, and FileError.
RunResult record_run(PackingRun& packing, Hdf5Recorder& recorder, const Scenario& scenario,
                     const RunTotals& before, std::FILE* table);

/// A duration for people: "45 s", "12 min".
std::string shown_time(double seconds);

/// The result in numbers, as lines that start with '#'.
std::string summary(const RunResult& result, const PackingProgress& progress,
                    const Scenario& scenario);

/// Length at which the run is expected to end: by the limits on length, density and increments, or
/// else by the law phi_max = 0.98 (a/R)^0.38 for a limit on the force (published for high torsion;
/// a rough guide for others).
double expected_length(const Scenario& scenario);

}  // namespace wirepack
