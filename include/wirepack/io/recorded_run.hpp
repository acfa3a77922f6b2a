#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "wirepack/packing/packing_progress.hpp"
#include "wirepack/packing/run_totals.hpp"
#include "wirepack/packing/scenario.hpp"
#include "wirepack/packing/stop_rule.hpp"

namespace wirepack {

/// What is done with a result that is there.
enum class Existing {
  refuse,   ///< InvalidInput
  replace,  ///< begins anew
  go_on,    ///< from its last increment, to the same bits as an undisturbed run
};

struct RecordOptions {
  Existing existing = Existing::refuse;
  std::string command_line = {};                  ///< kept in the file
  std::map<std::string, std::string> notes = {};  ///< attributes to keep, such as length_unit
  std::vector<std::string> given_keys = {};  ///< named first where they keep a run from going on
};

/// What a caller wants to be told or asked; each may be empty.
struct RunHooks {
  /// Before the first increment, with the row that it starts from.
  std::function<void(const HistoryRow&)> on_start;
  std::function<void(const HistoryRow&, const PackingProgress&)> on_increment;
  /// Sentences for people: where a run goes on, a lock that may not hold, damage of a file.
  std::function<void(const std::string&)> say;
  std::function<bool()>
      stop_requested;  ///< before each increment; ends the run, with all of it saved
  std::function<bool()> save_requested;  ///< after each increment
};

struct RecordedRun {
  std::optional<StopReason> stop;  ///< nothing: stopped on request
  bool was_over = false;           ///< the result was at its end before; nothing was computed
  HistoryRow last;                 ///< of the last increment, in the units of the scenario
  RunTotals totals;
  PackingProgress progress;           ///< in units of the wire, see PackingRun
  std::vector<std::string> warnings;  ///< of the end; those of the scenario not among them
};

/// The run that a result holds, if the limits of the scenario leave nothing to compute. Throws as
/// run_recorded() does.
std::optional<RecordedRun> run_before(const Scenario& scenario, const std::filesystem::path& file,
                                      const RecordOptions& options = {});

/// Runs a scenario to a limit and keeps the result in a file, whose lock it has meanwhile:
/// everything goes there at the start, with every frame, every output.checkpoint_every_seconds
/// (where saving would take more than 2 % of the time, and that is not 0, later), on request, and
/// at the end; before the last increment, too, if a limit ends the run. To go on, limits and output
/// of the scenario may be others than those of the result, and so may [minimizer] and [insertion]
/// after a run that found no equilibrium; where nothing is there, the run begins.
///
/// Throws InvalidInput for a scenario that is not valid, or not that of the result;
/// NumericalFailure, with all increments before it saved; FileError, also when another process
/// writes the result.
RecordedRun run_recorded(const Scenario& scenario, const std::filesystem::path& file,
                         const RecordOptions& options = {}, const RunHooks& hooks = {});

}  // namespace wirepack
