#include "sweep_execution.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <numeric>
#include <thread>
#include <unistd.h>

#include "wirepack/core/error.hpp"

#include "command.hpp"
#include "process_pool.hpp"
#include "run_display.hpp"
#include "sweep_cost.hpp"
#include "terminal.hpp"

namespace wirepack {

namespace {

/// A line on a terminal: how many tasks are through, and about how long the rest takes.
class PoolProgress {
 public:
  PoolProgress(const Survey& tasks, const std::vector<std::size_t>& chosen)
      : shown_(::isatty(STDERR_FILENO) != 0) {
    for (const std::size_t k : chosen) costs_.push_back(expected_cost(tasks.status[k].scenario));
    whole_ = std::accumulate(costs_.begin(), costs_.end(), 0.0);
  }
  void ended(std::size_t task) {
    ended_ += 1;
    through_ += costs_[task];
  }
  void show() const {
    if (!shown_) return;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    std::string text = fmt::format("{} of {} tasks have ended", ended_, costs_.size());
    if (through_ > 0 && through_ < whole_) {
      const double left = passed.count() * (whole_ - through_) / through_;
      text += fmt::format(", about {} left", shown_time(left));
    }
    std::fputs(("\r" + text + "\033[K").c_str(), stderr);
  }
  void clear() const {
    if (shown_) std::fputs("\r\033[K", stderr);
  }

 private:
  bool shown_;
  std::vector<double> costs_;
  double whole_ = 0, through_ = 0;
  std::size_t ended_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::vector<std::string> task_command(const std::filesystem::path& folder,
                                      const SweepScriptOptions& options) {
  return {options.program,
          "run",
          (folder / task_config_file).string(),
          "-o",
          (folder / task_result_file).string(),
          "--resume",
          "--threads",
          std::to_string(options.threads),
          "--log",
          (folder / task_log_file).string()};
}

std::vector<std::string> names_of(const Survey& tasks, const std::vector<std::size_t>& chosen) {
  std::vector<std::string> names;
  for (const std::size_t k : chosen) names.push_back(tasks.list.tasks[k].name);
  return names;
}

}  // namespace

std::string this_program() {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw FileError("/proc/self/exe: cannot be read: " + error.message());
  return path.string();
}

bool run_here(const std::filesystem::path& folder, const Survey& tasks,
              const std::vector<std::size_t>& chosen, const SweepScriptOptions& options) {
  const std::vector<std::string> names = names_of(tasks, chosen);
  std::vector<std::vector<std::string>> commands;
  for (const std::string& name : names) commands.push_back(task_command(folder / name, options));
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  const int at_once =
      options.at_once > 0 ? options.at_once : std::max(1, processors / options.threads);
  PoolProgress progress(tasks, chosen);
  PoolEvents events;
  events.each_second = [&] { progress.show(); };
  events.ended = [&](std::size_t command, int code) {
    progress.ended(command);
    if (code == exit_done || code == exit_no_equilibrium || code == exit_stopped_by_signal) return;
    progress.clear();
    print_message("wirepack sweep: " + names[command] +
                  (code < 0 ? fmt::format(": killed by signal {}", -code)
                            : fmt::format(": exit code {}", code)));
  };
  const bool whole = run_processes(commands, ProcessKind::run, at_once, events);
  progress.clear();
  return whole;
}

std::filesystem::path write_script(const std::filesystem::path& folder, const Survey& tasks,
                                   const std::vector<std::size_t>& chosen, SweepEngine engine,
                                   const SweepScriptOptions& options) {
  return write_sweep_script(folder, engine, names_of(tasks, chosen), options);
}

std::optional<int> run_script(const std::filesystem::path& script, SweepEngine engine) {
  int result = 0;
  PoolEvents events{[&result](std::size_t, int code) { result = code; }, [] {}};
  if (!run_processes({{"bash", script.string()}}, ProcessKind::other, 1, events)) {
    return std::nullopt;
  }
  // GNU parallel ends with the number of tasks that have failed, 101 for more of them.
  constexpr int most_failures = 101;
  if (engine == SweepEngine::slurm ? result != 0 : result > most_failures) {
    throw FileError(fmt::format("{}: ended with code {}: not all tasks are {}", script.string(),
                                result, engine == SweepEngine::slurm ? "queued" : "run"));
  }
  return result;
}

}  // namespace wirepack
