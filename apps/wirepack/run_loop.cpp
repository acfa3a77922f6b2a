#include "run_loop.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

#include "wirepack/core/error.hpp"
#include "wirepack/io/history_table.hpp"
#include "wirepack/io/round_off.hpp"
#include "wirepack/observe/packing_density.hpp"
#include "wirepack/packing/longest_wire.hpp"
#include "wirepack/packing/warnings.hpp"

#include "stop_signals.hpp"

namespace wirepack {

namespace {

using Clock = std::chrono::steady_clock;

// A run with inertia is slow enough when on average it has less of its energy in motion.
constexpr double quasistatic_share = 0.02;

constexpr std::size_t terminal_columns = 80;

// Saving takes no larger share of a run's time, but for what signals and the end ask for.
constexpr double most_saving = 0.02;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// One line on a terminal that tells how far the run is.
class ProgressLine {
 public:
  ProgressLine(const Scenario& scenario, const HistoryRow& start)
      : shown_(::isatty(STDERR_FILENO) != 0), end_(expected_length(scenario)), start_(start) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void clear() {
    if (dirty_) std::fputs("\r\033[K", stderr);
    dirty_ = false;
  }

  void show(const HistoryRow& row, double seconds) {
    if (!shown_) return;
    std::string text =
        fmt::format("phi {:.4f}  F R^2/YI {:.3g}  {:.2f} increments/s", row.packing_density,
                    row.scaled_force, (row.increment - start_.increment) / std::max(seconds, 1e-3));
    // an increment costs in proportion to the wire that is inside
    const auto square = [](double v) { return v * v; };
    const double done = square(row.inserted_length) - square(start_.inserted_length);
    const double left = square(end_) - square(row.inserted_length);
    if (done > 0 && left > 0) {
      text += fmt::format("  about {} left", shown_time(seconds * left / done));
    }
    // a line that is wrapped could not be cleared
    fmt::print(stderr, "\r{}\033[K", std::string_view(text).substr(0, terminal_columns - 1));
    dirty_ = true;
  }

 private:
  bool shown_, dirty_ = false;
  double end_;
  HistoryRow start_;
};

/// When to save: with every frame and every so many seconds, if it does not take too much time.
class SavingTimes {
 public:
  explicit SavingTimes(double every_seconds) : every_seconds_(every_seconds) {}

  template <class Save>
  void time(Save&& save) {
    const Clock::time_point start = Clock::now();
    save();
    seconds_ = seconds_since(start);
    last_ = Clock::now();
    frame_waits_ = false;
  }
  void frame_waits() { frame_waits_ = true; }
  bool is_due() const {
    const double passed = seconds_since(last_);
    const bool wanted = frame_waits_ || passed >= every_seconds_;
    return wanted && (every_seconds_ == 0 || seconds_ <= most_saving * passed);
  }

 private:
  double every_seconds_, seconds_ = 0;
  bool frame_waits_ = false;
  Clock::time_point last_ = Clock::now();
};

}  // namespace

std::string shown_time(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

void RunTotals::add(const HistoryRow& row) {
  largest_residual = std::max(largest_residual, row.residual);
  largest_overlap = std::max(largest_overlap, row.max_overlap);
  kinetic += row.energy_kinetic;
  stored += row.energy_total;
  seconds = row.wall_seconds;
}

RunTotals totals_of(const std::vector<HistoryRow>& history, double last_increment) {
  RunTotals totals;
  for (const HistoryRow& row : history) {
    if (row.increment <= last_increment) totals.add(row);
  }
  return totals;
}

RunResult record_run(PackingRun& packing, Hdf5Recorder& recorder, const Scenario& scenario,
                     const RunTotals& before, std::FILE* table_file) {
  RunResult result;
  result.totals = before;
  const Clock::time_point start = Clock::now();
  const HistoryTable table(scenario);
  ProgressLine progress_line(scenario, packing.row());
  std::vector<std::string> found = warnings(scenario, expected_length(scenario));
  recorder.note("warnings", fmt::format("{}", fmt::join(found, "\n")));
  SavingTimes saving(scenario.output.checkpoint_every_seconds);
  // Shows now, and not after hours, that the file cannot be written.
  saving.time([&] { recorder.flush(packing.progress()); });
  double last_frame = -1;
  const auto take_frame = [&] {
    last_frame = packing.progress().last.increment;
    recorder.add(packing.take_frame());
  };

  if (table_file != nullptr) std::fputs(table.header().c_str(), table_file);
  PackingProgress good = packing.progress();
  try {
    while (!result.stop && !stop_was_requested() && !result.unread) {
      result.stop = packing.advance();
      const PackingProgress& progress = packing.progress();
      const bool advanced = progress.last.increment > good.last.increment;
      if (advanced) {
        // From here a run with larger limits goes on: the last increment may be cut short.
        if (result.stop) recorder.flush(good);
        HistoryRow row = packing.row();
        row.wall_seconds = before.seconds + seconds_since(start);
        recorder.add(row);
        result.totals.add(row);
        progress_line.clear();
        if (table_file != nullptr) {
          std::fputs(table.line(row, progress).c_str(), table_file);
          result.unread = std::fflush(table_file) != 0 && errno == EPIPE;
        }
        progress_line.show(row, seconds_since(start));
      }
      if (advanced && packing.frame_is_due()) {
        take_frame();
        saving.frame_waits();
      }
      good = packing.progress();
      if ((save_was_requested() || saving.is_due()) && !result.stop) {
        saving.time([&] { recorder.flush(good); });
      }
    }
  } catch (const NumericalFailure&) {
    recorder.flush(good);
    throw;
  }
  result.warnings = warnings(scenario, packing.progress(), result.totals.largest_overlap);
  found.insert(found.end(), result.warnings.begin(), result.warnings.end());
  recorder.note("warnings", fmt::format("{}", fmt::join(found, "\n")));
  // A run that a signal stopped goes on later; an extra frame would make it differ from others.
  const double last = packing.progress().last.increment;
  if (result.stop && last > 0 && last > last_frame) take_frame();
  recorder.flush(packing.progress(), result.stop);
  return result;
}

double expected_length(const Scenario& scenario) {
  const StopLimits& stop = scenario.stop;
  double length = longest_wire(scenario);
  if (stop.scaled_force || stop.force) {
    const double density = 0.98 * std::pow(scenario.wire.radius / scenario.cavity.radius, 0.38);
    length = std::min(length, length_at_density(density, scenario.cavity, scenario.wire.radius));
  }
  return length;
}

std::string summary(const RunResult& result, const PackingProgress& progress,
                    const Scenario& scenario, const DeclaredUnits& names) {
  const Units units = units_of(scenario);
  const HistoryRow last = in_units(progress.last, units);
  const WorkBalance balance = in_units(progress.balance, units);
  const double unit = units.scaled_energy();
  const double percent = balance.work != 0 ? 100 * residue(balance, last) / balance.work : 0;
  const RunTotals& totals = result.totals;
  const SolverWork& work = progress.work;
  std::string text = "#\n";
  const auto line = [&](std::string_view name, const std::string& value) {
    text += fmt::format("# {:<22}{}\n", name, value);
  };
  line("stopped by", result.stop ? std::string(name_of(*result.stop)) : "a signal");
  line("phi_max", fmt::format("{:.6f}", last.packing_density));
  line("inserted length", fmt::format("{:.6g} a", last.inserted_length / scenario.wire.radius));
  const auto energy = [&](std::string_view name, double value) {
    value = without_round_off(value, balance.work);
    line(name, fmt::format("{:.6g} YI/R = {}", value / unit, shown_energy(value, names)));
  };
  line("force",
       fmt::format("{:.6g} YI/R^2 = {}", last.scaled_force, shown_force(last.force, names)));
  energy("work int F dL", balance.work);
  energy("  stored energy", last.energy_total);
  if (scenario.method == Method::dynamic) {
    energy("  kinetic energy", last.energy_kinetic);
    energy("  rubbed off", balance.friction);
    energy("  viscous", balance.viscous);
  } else {
    energy("  released in snaps", balance.released);
    if (scenario.friction.model != FrictionModel::none) {
      energy("  rubbed off", balance.friction);
      energy("  held by contacts", balance.contact_springs);
    }
  }
  energy("  lost in remeshing", balance.remeshing);
  line("  residue", fmt::format("{:.3g} % of the work", percent));
  if (scenario.method == Method::dynamic) {
    const double share = totals.stored > 0 ? totals.kinetic / totals.stored : 0;
    line(
        "kinetic over stored",
        fmt::format("{:.2g} %, mean of the run{}", 100 * share,
                    share > quasistatic_share ? ": too fast; lower dynamics.insertion_speed" : ""));
    line("time steps", fmt::format("{}", work.evaluations));
  } else {
    line("snaps", fmt::format("{}", progress.snaps));
    line("rollbacks", fmt::format("{}", progress.rollbacks));
    line("evaluations", fmt::format("{}", work.evaluations));
    line("factorizations", fmt::format("{}", work.factorizations));
    line("  rounds taken back", fmt::format("{}", work.rounds_taken_back));
    line("neighbor lists made", fmt::format("{}", work.list_builds));
    line("largest residual", fmt::format("{:.3g} YI/R^2 (tolerance {:.3g})",
                                         totals.largest_residual, scenario.minimizer.tolerance));
  }
  line("largest overlap", fmt::format("{:.3g} a", totals.largest_overlap / scenario.wire.radius));
  line("time", fmt::format("{:.1f} s", totals.seconds));
  if (scenario.method == Method::dynamic) return text;  // one loop does all
  double rest = totals.seconds;
  const auto share = [&](std::string_view name, double seconds) {
    line(name, fmt::format("{:.2f} s, {:.0f} %", seconds, 100 * seconds / totals.seconds));
    rest -= seconds;
  };
  share("  energies", work.energy_seconds);
  share("  neighbor lists", work.list_seconds);
  share("  chart", work.chart_seconds);
  share("  triangular solves", work.solve_seconds);
  share("  factorizations", work.factorization_seconds);
  share("  L-BFGS", work.descent_seconds);
  share("  passages of strands", work.passage_seconds);
  share("  all else", rest);
  return text;
}

}  // namespace wirepack
