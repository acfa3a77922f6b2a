#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "wirepack/io/hdf5_recorder.hpp"
#include "wirepack/packing/declared_units.hpp"
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

/// Of the rows up to an increment.
RunTotals totals_of(const std::vector<HistoryRow>& history, double last_increment);

struct RunResult {
  std::optional<StopReason> stop;  ///< nothing: a signal stopped the run, or nobody reads the table
  RunTotals totals;
  bool unread = false;                ///< the reader of the table has gone away
  std::vector<std::string> warnings;  ///< of the end; those of the scenario not among them
};

/// Runs until a limit, a stop signal, or until the reader of the table has gone away: prints the table,
/// if one is wanted, and progress to stderr (on a terminal), and brings everything to the file at the
/// start, with every frame, every output.checkpoint_every_seconds (where saving would take more than 2 %
/// of the time, and that is not 0, later), on a signal, and at the end; before the last
/// increment, too, if a limit ends the run. Throws NumericalFailure, with all increments
/// before it saved, and FileError.
RunResult record_run(PackingRun& packing, Hdf5Recorder& recorder, const Scenario& scenario,
                     const RunTotals& before, std::FILE* table);

/// A duration for people: "45 s", "12 min".
std::string shown_time(double seconds);

/// The result in numbers, as lines that start with '#'.
/// Forces and energies also in the unit of the configuration, by its name if it is declared.
std::string summary(const RunResult& result, const PackingProgress& progress,
                    const Scenario& scenario, const DeclaredUnits& names = {});

/// Length at which the run is expected to end: by the limits on length, density and increments, or
/// else by the law phi_max = 0.98 (a/R)^0.38 for a limit on the force (published for high torsion;
/// a rough guide for others).
double expected_length(const Scenario& scenario);

}  // namespace wirepack
