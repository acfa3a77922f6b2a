#include "run_display.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <optional>
#include <unistd.h>

#include "wirepack/io/history_table.hpp"
#include "wirepack/io/round_off.hpp"
#include "wirepack/packing/longest_wire.hpp"
#include "wirepack/packing/own_units.hpp"

#include "stop_signals.hpp"

namespace wirepack {

namespace {

using Clock = std::chrono::steady_clock;

// A run with inertia is slow enough when on average it has less of its energy in motion.
constexpr double quasistatic_share = 0.02;

constexpr std::size_t terminal_columns = 80;

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

}  // namespace

std::string shown_time(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

struct RunDisplay::Shown {
  std::FILE* file;
  HistoryTable table;
  Scenario scenario;
  std::optional<ProgressLine> progress;
  Clock::time_point start;
  bool unread = false;

  void begin(const HistoryRow& row) {
    start = Clock::now();
    progress.emplace(scenario, row);
    if (file != nullptr) std::fputs(table.header().c_str(), file);
  }

  void add(const HistoryRow& row, const PackingProgress& after) {
    progress->clear();
    if (file != nullptr) {
      std::fputs(table.line(row, after).c_str(), file);
      unread = std::fflush(file) != 0 && errno == EPIPE;
    }
    progress->show(row, seconds_since(start));
  }
};

RunDisplay::RunDisplay(const Scenario& scenario, std::FILE* table)
    : shown_(new Shown{table, HistoryTable(scenario), scenario, {}, {}}) {}

RunDisplay::~RunDisplay() = default;

RunHooks RunDisplay::hooks() {
  Shown* shown = shown_.get();
  RunHooks hooks;
  hooks.on_start = [shown](const HistoryRow& row) { shown->begin(row); };
  hooks.on_increment = [shown](const HistoryRow& row, const PackingProgress& after) {
    shown->add(row, after);
  };
  hooks.stop_requested = [shown] { return stop_was_requested() || shown->unread; };
  hooks.save_requested = save_was_requested;
  return hooks;
}

bool RunDisplay::unread() const { return shown_->unread; }

std::string summary(const RecordedRun& run, const Scenario& scenario, const DeclaredUnits& names) {
  const PackingProgress& progress = run.progress;
  const Units units = units_of(scenario);
  const HistoryRow& last = run.last;
  const WorkBalance balance = in_units(progress.balance, units);
  const double unit = units.scaled_energy();
  const double percent = balance.work != 0 ? 100 * residue(balance, last) / balance.work : 0;
  const RunTotals& totals = run.totals;
  const SolverWork& work = progress.work;
  std::string text = "#\n";
  const auto line = [&](std::string_view name, const std::string& value) {
    text += fmt::format("# {:<22}{}\n", name, value);
  };
  line("stopped by", run.stop ? std::string(name_of(*run.stop)) : "a signal");
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
