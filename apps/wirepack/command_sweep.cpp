#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <numeric>
#include <thread>
#include <unistd.h>

#include "wirepack/core/error.hpp"
#include "wirepack/io/sweep_folder.hpp"
#include "wirepack/io/sweep_page.hpp"
#include "wirepack/io/sweep_plan.hpp"
#include "wirepack/io/sweep_script.hpp"
#include "wirepack/io/sweep_status.hpp"
#include "wirepack/io/sweep_tables.hpp"
#include "wirepack/packing/longest_wire.hpp"

#include "command.hpp"
#include "process_pool.hpp"
#include "run_advice.hpp"
#include "run_display.hpp"
#include "sweep_cost.hpp"
#include "terminal.hpp"

namespace wirepack {

namespace {

enum class Executor { local, slurm, parallel };

struct Options {
  std::string plan, folder, status, collect;
  Executor executor = Executor::local;
  std::optional<SweepEngine> emit;
  int jobs = 0;
  bool dry_run = false, page = false;
  SweepScriptOptions script;
};

void say(const std::string& message) { print_message("wirepack sweep: " + message); }

/// All tasks of a folder, in the order of its list.
struct Survey {
  TaskList list;
  std::vector<TaskStatus> status;

  std::size_t count(TaskState state) const {
    return static_cast<std::size_t>(
        std::count_if(status.begin(), status.end(),
                      [state](const TaskStatus& task) { return task.state == state; }));
  }
};

Survey survey(const std::filesystem::path& folder) {
  Survey result{read_task_list(folder), {}};
  for (const ListedTask& task : result.list.tasks) {
    result.status.push_back(task_status(folder / task.name));
  }
  return result;
}

std::string counts(const Survey& tasks) {
  std::string text;
  for (const TaskState state : all_task_states) {
    const std::size_t count = tasks.count(state);
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name_of(state));
  }
  return fmt::format("{} tasks: {}", tasks.status.size(), text);
}

std::string hours(double seconds) {
  return seconds < 0 ? "?" : fmt::format("{:.3f}", seconds / 3600);
}

std::string remark(const TaskStatus& task) {
  const std::string& reason = task.remark.empty() ? task.stop_reason : task.remark;
  return task.state == TaskState::failed ? fmt::format("exit code {}: {}", task.exit_code, reason)
                                         : reason;
}

int show_status(const std::filesystem::path& folder, bool page) {
  const Survey tasks = survey(folder);
  const std::vector<double> left = seconds_left(tasks.status);
  std::size_t width = 5;
  for (const ListedTask& task : tasks.list.tasks) width = std::max(width, task.name.size());
  std::string text = fmt::format("#{:<{}} {:<14} {:>9} {:>10} {:>10} {:>10}  {}\n", "task", width,
                                 "state", "phi", "increment", "hours", "left", "remark");
  double spent = 0, rest = 0;
  for (std::size_t k = 0; k < tasks.status.size(); ++k) {
    const TaskStatus& task = tasks.status[k];
    text += fmt::format(" {:<{}} {:<14} {:>9.4f} {:>10.0f} {:>10} {:>10}  {}\n",
                        tasks.list.tasks[k].name, width, name_of(task.state),
                        task.last.packing_density, task.last.increment,
                        hours(task.last.wall_seconds), hours(left[k]), remark(task));
    spent += task.last.wall_seconds;
    rest = rest < 0 || left[k] < 0 ? -1 : rest + left[k];
  }
  text += fmt::format("# {}\n# hours of one processor: {} spent, about {} left\n", counts(tasks),
                      hours(spent), hours(rest));
  for (const std::string& name : tasks_beyond(tasks.list, folder)) {
    text += fmt::format("# {} is of an earlier plan\n", name);
  }
  print_lines(text);
  if (!page) return exit_done;
  std::vector<SweepPageTask> lines;
  for (std::size_t k = 0; k < tasks.status.size(); ++k) {
    lines.push_back({tasks.list.tasks[k].name, tasks.status[k], left[k]});
  }
  say(write_sweep_page(folder, counts(tasks), lines).string() + " is written");
  return exit_done;
}

int collect(const std::filesystem::path& folder) {
  for (const std::filesystem::path& file : write_sweep_tables(folder)) {
    print_lines(file.string() + "\n");
  }
  return exit_done;
}

// The path of this program: tasks run by the same one.
std::string this_program() {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw FileError("/proc/self/exe: cannot be read: " + error.message());
  return path.string();
}

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

std::vector<std::string> task_command(const std::filesystem::path& folder, const Options& options) {
  return {options.script.program,
          "run",
          (folder / task_config_file).string(),
          "-o",
          (folder / task_result_file).string(),
          "--resume",
          "--threads",
          std::to_string(options.script.threads),
          "--log",
          (folder / task_log_file).string()};
}

/// Runs the chosen tasks here. False: a signal has stopped them.
bool run_here(const Survey& tasks, const std::vector<std::size_t>& chosen, const Options& options) {
  std::vector<std::vector<std::string>> commands;
  for (const std::size_t k : chosen) {
    commands.push_back(
        task_command(std::filesystem::path(options.folder) / tasks.list.tasks[k].name, options));
  }
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  const int at_once =
      options.jobs > 0 ? options.jobs : std::max(1, processors / options.script.threads);
  PoolProgress progress(tasks, chosen);
  PoolEvents events;
  events.each_second = [&] { progress.show(); };
  events.ended = [&](std::size_t command, int code) {
    progress.ended(command);
    if (code == exit_done || code == exit_no_equilibrium || code == exit_stopped_by_signal) return;
    progress.clear();
    const std::string& name = tasks.list.tasks[chosen[command]].name;
    say(code < 0 ? fmt::format("{}: killed by signal {}", name, -code)
                 : fmt::format("{}: exit code {}", name, code));
  };
  const bool whole = run_processes(commands, ProcessKind::run, at_once, events);
  progress.clear();
  return whole;
}

std::filesystem::path write_script(const Survey& tasks, const std::vector<std::size_t>& chosen,
                                   SweepEngine engine, const Options& options) {
  std::vector<std::string> names;
  for (const std::size_t k : chosen) names.push_back(tasks.list.tasks[k].name);
  SweepScriptOptions script = options.script;
  script.at_once = options.jobs;
  return write_sweep_script(options.folder, engine, names, script);
}

/// Hands the chosen tasks to another program. False: a signal has stopped them.
bool run_script(const std::filesystem::path& script) {
  int result = 0;
  PoolEvents events{[&result](std::size_t, int code) { result = code; }, [] {}};
  const bool whole = run_processes({{"bash", script.string()}}, ProcessKind::other, 1, events);
  if (whole && result != 0) say(fmt::format("{} ended with code {}", script.string(), result));
  return whole;
}

int exit_code_of(const Survey& tasks) {
  int code = tasks.count(TaskState::no_equilibrium) > 0 ? exit_no_equilibrium : exit_done;
  const auto left = [&](TaskState state) { return tasks.count(state) > 0; };
  if (left(TaskState::running)) code = exit_file_error;
  if (left(TaskState::resumable) || left(TaskState::waiting)) code = exit_stopped_by_signal;
  for (const TaskStatus& task : tasks.status) {
    if (task.state == TaskState::failed) code = task.exit_code;
  }
  return code;
}

void say_changes(const SweepChange& change, const Sweep& sweep, const Options& options) {
  say(fmt::format("{}: {} tasks, {} of them new", options.folder, sweep.tasks.size(),
                  change.added.size()));
  for (const std::string& name : change.changed) say(name + " has other limits or output now");
  for (const std::string& name : tasks_beyond(read_task_list(options.folder), options.folder)) {
    say(name + " is of an earlier plan: it is not run, and nothing of it is removed");
  }
}

int finish(bool stopped, const Survey& tasks) {
  for (std::size_t k = 0; k < tasks.status.size(); ++k) {
    const TaskStatus& task = tasks.status[k];
    if (task.state == TaskState::failed) {
      say(fmt::format("{}: failed, {}", tasks.list.tasks[k].name, remark(task)));
    } else if (task.state == TaskState::running) {
      say(fmt::format("{}: is run by {}", tasks.list.tasks[k].name, task.remark));
    }
  }
  fmt::print("# {}\n", counts(tasks));
  if (stopped) {
    say("stopped by a signal; the same command goes on from there");
    return exit_stopped_by_signal;
  }
  return exit_code_of(tasks);
}

Sweep planned(const Options& options) {
  if (options.plan.empty()) throw InvalidInput("PLAN.toml is needed, or --status or --collect");
  Sweep sweep = read_sweep(options.plan);
  for (const SweepTask& task : sweep.tasks) {
    require_possible(task.scenario, expected_length(task.scenario));
  }
  // Long tasks first: the last ones to end are short.
  std::stable_sort(sweep.tasks.begin(), sweep.tasks.end(), [](const auto& a, const auto& b) {
    return expected_cost(a.scenario) > expected_cost(b.scenario);
  });
  return sweep;
}

void require_fitting(const Options& options) {
  const bool parallel =
      options.emit ? options.emit == SweepEngine::parallel : options.executor == Executor::parallel;
  if (!options.script.hosts.empty() && !parallel) {
    throw InvalidInput("--hosts goes with --executor parallel or --emit parallel");
  }
  const bool slots = options.emit == SweepEngine::snakemake ||  // has cores, and HyperQueue workers
                     options.emit == SweepEngine::hyperqueue;
  if (options.jobs > 0 && slots) {
    throw InvalidInput("--jobs goes with slurm and parallel; others share out their own cores");
  }
}

int sweep(Options options) {
  if (!options.status.empty()) return show_status(options.status, options.page);
  if (!options.collect.empty()) return collect(options.collect);
  require_fitting(options);
  const Sweep plan = planned(options);
  if (options.dry_run) {
    for (const SweepTask& task : plan.tasks) fmt::print("{}\n", task.name);
    fmt::print("# {} tasks, the longest first\n", plan.tasks.size());
    return exit_done;
  }
  if (options.folder.empty()) throw InvalidInput("-o DIR is needed: where the tasks go");
  options.script.program = this_program();
  say_changes(write_sweep(options.folder, plan), plan, options);
  const Survey tasks = survey(options.folder);
  std::vector<std::size_t> all(tasks.status.size()), open;
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::copy_if(all.begin(), all.end(), std::back_inserter(open),
               [&](std::size_t k) { return can_go_on(tasks.status[k].state); });
  if (options.emit) {
    print_lines(write_script(tasks, open, *options.emit, options).string() + "\n");
    return exit_done;
  }
  if (open.empty()) return finish(false, tasks);
  if (options.executor == Executor::slurm) {
    return run_script(write_script(tasks, open, SweepEngine::slurm, options))
               ? exit_done
               : exit_stopped_by_signal;
  }
  const bool whole = options.executor == Executor::local
                         ? run_here(tasks, open, options)
                         : run_script(write_script(tasks, open, SweepEngine::parallel, options));
  return finish(!whole, survey(options.folder));
}

}  // namespace

Command sweep_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("sweep", "Many runs that differ in some keys: each finished once");
  app->set_help_flag("--help,-h", "This help");
  const auto options = std::make_shared<Options>();
  app->add_option("PLAN.toml", options->plan, "A configuration with the keys that vary in [sweep]");
  app->add_option("-o,--output", options->folder,
                  "Folder of the tasks; tasks that are there are gone on with, or are finished")
      ->type_name("DIR");
  app->add_option("--executor", options->executor, "Who runs the tasks; local by default")
      ->type_name("local|slurm|parallel")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Executor>{{"local", Executor::local},
                                          {"slurm", Executor::slurm},
                                          {"parallel", Executor::parallel}}));
  app->add_option("--emit", options->emit, "Only writes what this program needs to run the tasks")
      ->type_name("slurm|parallel|snakemake|hyperqueue")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, SweepEngine>{{"slurm", SweepEngine::slurm},
                                             {"parallel", SweepEngine::parallel},
                                             {"snakemake", SweepEngine::snakemake},
                                             {"hyperqueue", SweepEngine::hyperqueue}}));
  app->add_option("--hosts", options->script.hosts,
                  "With parallel: hosts to run on by ssh, a line each, as --sshloginfile of GNU "
                  "parallel has them; they share DIR and have wirepack at the same place")
      ->type_name("FILE")
      ->check(CLI::ExistingFile);
  app->add_option("--jobs", options->jobs, "Tasks at a time; all processors by default")
      ->type_name("N")
      ->check(CLI::Range(1, 100000));
  app->add_option("--threads", options->script.threads, "Threads of each task, 1 by default")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  app->add_option("--tasks-per-job", options->script.tasks_per_job,
                  "Tasks of a job of Slurm, one after the other; 1 by default")
      ->type_name("N")
      ->check(CLI::Range(1, 100000));
  app->add_option("--restarts", options->script.most_restarts,
                  "How often a job of Slurm that reaches its time limit is queued again")
      ->type_name("N")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  app->add_flag("--dry-run", options->dry_run, "Prints the tasks and writes nothing");
  CLI::Option* status = app->add_option("--status", options->status,
                                        "Prints what has become of the tasks of a folder")
                            ->type_name("DIR");
  app->add_flag("--page", options->page,
                "With --status: writes DIR/status.html with small pictures and curves, too")
      ->needs(status);
  app->add_option("--collect", options->collect, "Writes tables over the seeds, as CSV")
      ->type_name("DIR");
  app->footer(
      "Examples: wirepack sweep data/scenarios/sweep.toml -o sweep\n"
      "          wirepack sweep --status sweep\n"
      "          wirepack sweep data/scenarios/sweep.toml -o sweep --emit slurm\n"
      "Exit codes: those of wirepack run, the worst of all tasks; 75 while some are left");
  return {app, [options] { return sweep(*options); }};
}

}  // namespace wirepack
