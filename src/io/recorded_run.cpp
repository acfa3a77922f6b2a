#include "wirepack/io/recorded_run.hpp"

#include <chrono>
#include <fmt/format.h>
#include <utility>

#include "wirepack/core/error.hpp"
#include "wirepack/io/config_file.hpp"
#include "wirepack/io/continuation.hpp"
#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/io/hdf5_recorder.hpp"
#include "wirepack/io/output_path.hpp"
#include "wirepack/io/result_end.hpp"
#include "wirepack/io/result_lock.hpp"
#include "wirepack/packing/longest_wire.hpp"
#include "wirepack/packing/packing_run.hpp"
#include "wirepack/packing/warnings.hpp"

#include "saving_times.hpp"

namespace wirepack {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

template <class Hook, class... Arguments>
auto call(const Hook& hook, const Arguments&... arguments) {
  using Answer = decltype(hook(arguments...));
  return hook ? hook(arguments...) : Answer();
}

std::string lines_of(const std::vector<std::string>& lines) {
  return fmt::format("{}", fmt::join(lines, "\n"));
}

/// Increments, and what of them is brought to the file when.
class Recording {
 public:
  Recording(const Scenario& scenario, PackingRun& packing, Hdf5Recorder& recorder,
            const RunHooks& hooks, const RunTotals& before)
      : scenario_(scenario),
        packing_(packing),
        recorder_(recorder),
        hooks_(hooks),
        before_(before),
        warnings_(warnings(scenario, expected_length(scenario))),
        good_(packing.progress()),
        saving_(scenario.output.checkpoint_every_seconds) {
    run_.totals = before;
  }

  RecordedRun run() {
    recorder_.note("warnings", lines_of(warnings_));
    // Shows now, and not after hours, that the file cannot be written.
    flush();
    call(hooks_.on_start, packing_.row());
    try {
      while (!run_.stop && !call(hooks_.stop_requested)) advance();
    } catch (const NumericalFailure&) {
      recorder_.flush(good_);
      throw;
    }
    finish();
    return std::move(run_);
  }

 private:
  void advance() {
    Advance step = packing_.advance();
    run_.stop = step.stop;
    // From here a run with larger limits goes on: the last increment may be cut short.
    if (step.row && step.stop) recorder_.flush(good_);
    if (step.row) add(*step.row);
    if (step.row && packing_.frame_is_due()) {
      take_frame();
      saving_.frame_waits();
    }
    good_ = packing_.progress();
    if ((call(hooks_.save_requested) || saving_.is_due()) && !run_.stop) flush();
  }

  void add(HistoryRow row) {
    row.wall_seconds = before_.seconds + seconds_since(start_);
    recorder_.add(row);
    run_.totals.add(row);
    call(hooks_.on_increment, row, packing_.progress());
  }

  void take_frame() {
    last_frame_ = packing_.progress().last.increment;
    recorder_.add(packing_.take_frame());
  }

  void flush() {
    saving_.time([&] { recorder_.flush(good_); });
  }

  void finish() {
    run_.warnings = warnings(scenario_, packing_.progress(), run_.totals.largest_overlap);
    warnings_.insert(warnings_.end(), run_.warnings.begin(), run_.warnings.end());
    recorder_.note("warnings", lines_of(warnings_));
    // A run that was stopped on request goes on later; an extra frame would make it differ from
    // others.
    const double last = packing_.progress().last.increment;
    if (run_.stop && last > 0 && last > last_frame_) take_frame();
    run_.progress = packing_.progress();
    run_.last = packing_.row();
    recorder_.flush(run_.progress, run_.stop);
  }

  const Scenario& scenario_;
  PackingRun& packing_;
  Hdf5Recorder& recorder_;
  const RunHooks& hooks_;
  RunTotals before_;
  std::vector<std::string> warnings_;
  PackingProgress good_;  // after the last good increment, with its frame taken
  RecordedRun run_;
  double last_frame_ = -1;
  SavingTimes saving_;
  Clock::time_point start_ = Clock::now();
};

/// The ways to look for an equilibrium that are not those of a result which found none.
std::vector<std::string> changed_search(const Hdf5Reader& reader, const Scenario& scenario) {
  const std::string reason = reader.stop_reason();
  const bool lost = reason == name_of(StopReason::no_equilibrium) ||
                    reason == name_of(StopReason::strands_passed);
  return lost ? search_changes(reader.scenario(), scenario) : std::vector<std::string>();
}

/// How a result ends that is at its end; nothing if it can go on.
std::optional<StopReason> end_before(const Hdf5Reader& reader, const fs::path& file,
                                     const Scenario& scenario, const RecordOptions& options) {
  const Scenario saved = reader.scenario();
  const std::vector<std::string> changes = changed_search(reader, scenario);
  Scenario compared = scenario;
  if (!changes.empty()) {  // how to look for the next equilibrium may be another
    compared.minimizer = saved.minimizer;
    compared.insertion = saved.insertion;
  }
  if (const auto conflict = continuation_conflict(saved, compared, options.given_keys)) {
    throw InvalidInput(fmt::format("{} cannot be continued with this configuration: {}",
                                   file.string(), *conflict));
  }
  const std::optional<StopReason> end = end_of(reader, scenario);
  if (!end || (found_no_equilibrium(*end) && !changes.empty())) return std::nullopt;
  return end;
}

RecordedRun begin(const Scenario& scenario, const fs::path& target, const RecordOptions& options,
                  const RunHooks& hooks) {
  PackingRun packing(scenario);
  Hdf5Recorder recorder(target, scenario, options.command_line);
  for (const auto& [name, text] : options.notes) recorder.note(name, text);
  return Recording(scenario, packing, recorder, hooks, {}).run();
}

RecordedRun go_on(const Scenario& scenario, const fs::path& file, const RecordOptions& options,
                  const RunHooks& hooks) {
  const Hdf5Reader reader(file);
  if (const std::string damage = reader.damage(); !damage.empty()) {
    call(hooks.say, damage + "; the checkpoint before is taken");
  }
  PackingProgress progress = place_to_go_on(reader);
  const RunTotals totals = totals_of(reader.history(), progress.last.increment);
  std::string history = reader.note("search_changes");
  for (const std::string& change : changed_search(reader, scenario)) {
    history += fmt::format("{}after increment {:.0f}: {}", history.empty() ? "" : "\n",
                           progress.last.increment, change);
  }
  call(hooks.say,
       fmt::format("{}: going on after increment {:.0f}", file.string(), progress.last.increment));
  Hdf5Recorder recorder = Hdf5Recorder::continuing(output_file(file, {.inputs = {}, .force = true}),
                                                   scenario, options.command_line, progress);
  PackingRun packing(scenario, std::move(progress));
  if (!history.empty()) recorder.note("search_changes", history);
  for (const auto& [name, text] : options.notes) recorder.note(name, text);
  return Recording(scenario, packing, recorder, hooks, totals).run();
}

}  // namespace

std::optional<RecordedRun> run_before(const Scenario& scenario, const fs::path& file,
                                      const RecordOptions& options) {
  const Hdf5Reader reader(file);
  const std::optional<StopReason> end = end_before(reader, file, scenario, options);
  if (!end) return std::nullopt;
  RecordedRun run;
  run.stop = end;
  run.was_over = true;
  run.progress = reader.progress();
  run.last = in_units(run.progress.last, units_of(scenario));
  run.totals = totals_of(reader.history(), run.last.increment);
  return run;
}

RecordedRun run_recorded(const Scenario& scenario, const fs::path& file,
                         const RecordOptions& options, const RunHooks& hooks) {
  require_valid(scenario);
  const fs::path target = output_file(file, {.inputs = {}, .force = true});
  const auto goes_on = [&] { return options.existing == Existing::go_on && fs::exists(target); };
  // A result that is at its end needs no lock.
  if (goes_on()) {
    if (auto over = run_before(scenario, file, options)) return *std::move(over);
  }
  const ResultLock lock(file);
  if (!lock.doubt().empty()) {
    call(hooks.say,
         fmt::format("take care that no second run writes {}: {}", file.string(), lock.doubt()));
  }
  // Asked again: another run may have made it, or brought it to its end, before this one had the
  // lock.
  if (goes_on()) {
    if (auto over = run_before(scenario, file, options)) return *std::move(over);
    return go_on(scenario, file, options, hooks);
  }
  if (options.existing == Existing::refuse && fs::exists(target)) {
    throw InvalidInput(file.string() + " exists");
  }
  return begin(scenario, target, options, hooks);
}

}  // namespace wirepack
