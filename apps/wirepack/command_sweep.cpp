#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>

#include "wirepack/core/error.hpp"
#include "wirepack/core/threads.hpp"
#include "wirepack/io/sweep_folder.hpp"
#include "wirepack/io/sweep_plan.hpp"
#include "wirepack/io/sweep_tables.hpp"
#include "wirepack/packing/longest_wire.hpp"

#include "command.hpp"
#include "named_choice.hpp"
#include "run_advice.hpp"
#include "sweep_cost.hpp"
#include "sweep_execution.hpp"
#include "sweep_report.hpp"
#include "sweep_survey.hpp"
#include "terminal.hpp"

namespace wirepack {

namespace {

enum class Executor { local, slurm, parallel };

struct Options {
  std::string plan, folder, status, collect;
  Executor executor = Executor::local;
  std::optional<SweepEngine> emit;
  bool dry_run = false, page = false;
  SweepScriptOptions script;
};

void say(const std::string& message) { print_message("wirepack sweep: " + message); }

int show_status(const std::filesystem::path& folder, bool page) {
  const Survey tasks = survey(folder);
  print_lines(status_text(folder, tasks));
  if (page) say(write_status_page(folder, tasks).string() + " is written");
  return exit_done;
}

int collect(const std::filesystem::path& folder) {
  for (const std::filesystem::path& file : write_sweep_tables(folder)) {
    print_lines(file.string() + "\n");
  }
  return exit_done;
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

// Tasks that neither are finished nor at work.
std::vector<std::size_t> open_tasks(const Survey& tasks) {
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < tasks.status.size(); ++k) {
    if (can_go_on(tasks.status[k].state)) open.push_back(k);
  }
  return open;
}

int execute(const Options& options, const Survey& tasks, const std::vector<std::size_t>& open) {
  const std::filesystem::path folder = options.folder;
  if (options.executor == Executor::local) {
    const bool whole = run_here(folder, tasks, open, options.script);
    return finish(!whole, survey(folder));
  }
  const SweepEngine engine =
      options.executor == Executor::slurm ? SweepEngine::slurm : SweepEngine::parallel;
  const std::filesystem::path script = write_script(folder, tasks, open, engine, options.script);
  const std::optional<int> code = run_script(script, engine);
  if (engine == SweepEngine::slurm) return code ? exit_done : exit_stopped_by_signal;
  if (code && *code != 0) say(fmt::format("{} ended with code {}", script.string(), *code));
  return finish(!code, survey(folder));
}

void require_fitting(const Options& options) {
  const bool parallel =
      options.emit ? options.emit == SweepEngine::parallel : options.executor == Executor::parallel;
  if (!options.script.hosts.empty() && !parallel) {
    throw InvalidInput("--hosts goes with --executor parallel or --emit parallel");
  }
  const bool slots = options.emit == SweepEngine::snakemake ||  // has cores, and HyperQueue workers
                     options.emit == SweepEngine::hyperqueue;
  if (options.script.at_once > 0 && slots) {
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
  const std::vector<std::size_t> open = open_tasks(tasks);
  if (options.emit) {
    const auto script = write_script(options.folder, tasks, open, *options.emit, options.script);
    print_lines(script.string() + "\n");
    return exit_done;
  }
  if (open.empty()) return finish(false, tasks);
  return execute(options, tasks, open);
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
  add_choice<Executor>(
      *app, "--executor", options->executor, "Who runs the tasks; local by default",
      {{"local", Executor::local}, {"slurm", Executor::slurm}, {"parallel", Executor::parallel}});
  add_choice<SweepEngine>(*app, "--emit", options->emit,
                          "Only writes what this program needs to run the tasks",
                          {{"slurm", SweepEngine::slurm},
                           {"parallel", SweepEngine::parallel},
                           {"snakemake", SweepEngine::snakemake},
                           {"hyperqueue", SweepEngine::hyperqueue}});
  app->add_option("--hosts", options->script.hosts,
                  "With parallel: hosts to run on by ssh, a line each, as --sshloginfile of GNU "
                  "parallel has them; they share DIR and have wirepack at the same place")
      ->type_name("FILE")
      ->check(CLI::Validator(CLI::ExistingFile).description(""));
  app->add_option("--jobs", options->script.at_once, "Tasks at a time; all processors by default")
      ->type_name("N")
      ->check(CLI::Range(1, 100000));
  app->add_option("--threads", options->script.threads, "Threads of each task, 1 by default")
      ->type_name("N")
      ->check(CLI::Range(1, most_threads));
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
  app->add_flag(
         "--page", options->page,
         "With --status: writes DIR/status.html with small pictures and curves, which lead to "
         "pages as of wirepack view")
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
