#include "run_display.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <optional>
#include <unistd.h>

#include "wirepack/io/history_table.hpp"
#include "wirepack/packing/longest_wire.hpp"

#include "stop_signals.hpp"

namespace wirepack {

namespace {

using Clock = std::chrono::steady_clock;

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

}  // namespace wirepack
