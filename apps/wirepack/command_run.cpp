#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <unistd.h>
#include <vector>

#include "wirepack/core/error.hpp"
#include "wirepack/core/threads.hpp"
#include "wirepack/io/config_file.hpp"
#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/io/output_path.hpp"
#include "wirepack/io/recorded_run.hpp"
#include "wirepack/io/result_end.hpp"
#include "wirepack/io/sweep_status.hpp"
#include "wirepack/observe/packing_density.hpp"
#include "wirepack/packing/longest_wire.hpp"
#include "wirepack/packing/warnings.hpp"

#include "command.hpp"
#include "run_advice.hpp"
#include "run_display.hpp"
#include "run_summary.hpp"
#include "stop_signals.hpp"
#include "terminal.hpp"

namespace wirepack {

namespace {

struct RunOptions {
  std::string config, output, method, log, command_line;
  std::vector<std::string> assignments;
  bool resume = false, force = false, dry_run = false;
  int threads = 1;
};

void say(const std::string& message) { print_message("wirepack run: " + message); }

std::vector<ConfigOverride> overrides_of(const RunOptions& options) {
  std::vector<ConfigOverride> overrides;
  for (const std::string& assignment : options.assignments) {
    overrides.push_back({assignment, "--set " + assignment});
  }
  if (!options.method.empty()) {
    overrides.push_back({"packing.method=" + options.method, "--method " + options.method});
  }
  return overrides;
}

int show_plan(const Scenario& scenario, const DeclaredUnits& names) {
  std::string text = resolved_config(scenario, names);
  const double length = expected_length(scenario);
  const Stiffness wire = stiffness(scenario.wire);
  const RunEstimate run = estimate(scenario, length);
  text += fmt::format(
      "\n# EI = {:.6g}, GJ = {:.6g}, EA = {:.6g}; YI/R^2 = {}, YI/R = {}\n"
      "# expected to end near L = {:.4g} (phi = {:.3g})\n"
      "# about {:.0f} nodes, {:.0f} increments, {:.0f} frames, {:.2g} MB, some {} of computing\n",
      wire.bend, wire.twist, wire.stretch, shown_force(force_unit(scenario), names),
      shown_energy(units_of(scenario).scaled_energy(), names), length,
      packing_density(length, scenario.cavity, scenario.wire.radius), run.nodes, run.increments,
      run.frames, run.bytes / 1e6, shown_time(std::max(1.0, run.seconds)));
  print_lines(text);
  say_warnings("run", warnings(scenario, length));
  return exit_done;
}

int exit_code(const RecordedRun& run) {
  if (!run.stop) return exit_stopped_by_signal;
  return found_no_equilibrium(*run.stop) ? exit_no_equilibrium : exit_done;
}

// Of a result that was at its end before.
int say_it_is_over(const RecordedRun& run, const Scenario& scenario, const RunOptions& options) {
  const std::string reason(name_of(*run.stop));
  if (!found_no_equilibrium(*run.stop) && !Hdf5Reader(options.output).finished()) {
    throw InvalidInput(options.output + ": is already beyond stop." + reason);
  }
  say(options.output + " is finished: " +
      (found_no_equilibrium(*run.stop) ? reason + "; " + what_to_try(scenario, *run.stop)
                                       : "stop." + reason + " is reached"));
  return exit_code(run);
}

RecordOptions record_options(const RunOptions& options, const Configuration& config) {
  const Existing existing = options.resume  ? Existing::go_on
                            : options.force ? Existing::replace
                                            : Existing::refuse;
  return {existing,
          options.command_line,
          {{"length_unit", config.units.length}, {"force_unit", config.units.force}},
          config.given_keys};
}

void say_why_it_stopped(const RecordedRun& run, const Scenario& scenario,
                        const std::string& saved) {
  if (!run.stop) {
    say("stopped by a signal; " + saved + "; --resume goes on from there");
  } else if (*run.stop == StopReason::no_equilibrium) {
    say("no equilibrium was found for the next increment, even in the smallest substep; " + saved +
        "; " + what_to_try(scenario, *run.stop));
  } else if (*run.stop == StopReason::strands_passed) {
    say("strands pass through each other in the next increment" +
        std::string(scenario.method == Method::dynamic ? "" : ", even in the smallest substep") +
        "; " + saved + "; " + what_to_try(scenario, *run.stop));
  }
}

int record(const Configuration& config, const RunOptions& options) {
  const Scenario& scenario = config.scenario;
  if (options.resume && !std::filesystem::exists(options.output)) {
    say(options.output + " is not there yet: starting from the beginning");
  }
  RunDisplay display(scenario, options.log.empty() ? stdout : nullptr);
  RunHooks hooks = display.hooks();
  hooks.say = say;
  hooks.on_start = [&, begin = hooks.on_start](const HistoryRow& row) {
    say_warnings("run", warnings(scenario, expected_length(scenario)));
    begin(row);
  };
  const RecordedRun run =
      run_recorded(scenario, options.output, record_options(options, config), hooks);
  if (run.was_over) return say_it_is_over(run, scenario, options);
  const std::string saved = fmt::format("{} holds all up to increment {:.0f}", options.output,
                                        run.progress.last.increment);
  if (display.unread()) {
    // what is left of the table has nowhere to go
    if (std::freopen("/dev/null", "w", stdout) == nullptr) return exit_file_error;
    say("nobody reads the table any more; " + saved + "; --resume goes on from there");
    return exit_stopped_by_signal;
  }
  print_lines(summary(run, scenario, config.units));
  print_lines(next_step(run.stop, options.output));
  std::fflush(stdout);
  say_warnings("run", run.warnings);
  say_why_it_stopped(run, scenario, saved);
  return exit_code(run);
}

// The log is added to, so it may be neither an input nor the result, under whatever name.
void check_log(const RunOptions& options, const OutputRules& rules) {
  const auto place = [](const std::filesystem::path& file, const OutputRules& of_file) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(output_file(file, of_file)));
  };
  const OutputRules added_to{rules.inputs, true};
  const std::filesystem::path log = place(options.log, added_to);
  const std::filesystem::path result = place(options.output, rules);
  std::error_code error;
  if (log == result || std::filesystem::equivalent(log, result, error)) {
    throw InvalidInput("--log " + options.log + ": is the result, " + options.output);
  }
}

/// From now on what is printed goes to the end of a file.
void print_to(const std::string& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  const bool printed_there = descriptor >= 0 && ::dup2(descriptor, STDOUT_FILENO) >= 0 &&
                             ::dup2(descriptor, STDERR_FILENO) >= 0;
  if (!printed_there) throw FileError(file + ": cannot be written: " + std::strerror(errno));
  ::close(descriptor);
}

int run(RunOptions options) {
  use_threads(options.threads);
  const Configuration config = read_configuration(options.config, overrides_of(options));
  const Scenario& scenario = config.scenario;
  require_possible(scenario, expected_length(scenario));
  if (options.dry_run) return show_plan(scenario, config.units);
  if (options.output.empty()) throw InvalidInput("-o OUT.h5 is needed: where the result goes");
  catch_stop_signals();
  const OutputRules rules{config.inputs, options.force || options.resume,
                          "--resume goes on from it, --force replaces it"};
  output_file(options.output, rules);
  if (!options.log.empty()) check_log(options, rules);
  if (options.resume && std::filesystem::exists(options.output)) {
    const auto over = run_before(scenario, options.output, record_options(options, config));
    if (over) return say_it_is_over(*over, scenario, options);
  }
  if (options.log.empty()) return record(config, options);
  print_to(options.log);
  const int code = run_safely("wirepack run", [&] { return record(config, options); });
  say(fmt::format("{}{}", exit_code_line, code));
  return code;
}

}  // namespace

Command run_command(CLI::App& program, const std::string& command_line) {
  auto options = std::make_shared<RunOptions>();
  options->command_line = command_line;
  CLI::App* app = program.add_subcommand("run", "One packing run");
  app->set_help_flag("--help,-h", "This help");
  app->add_option("CONFIG.toml", options->config, "Configuration; `[cavity] radius` is enough")
      ->required();
  app->add_option("-o,--output", options->output, "Result file (HDF5)")->type_name("OUT.h5");
  app->add_option("--set", options->assignments,
                  "Overrides a key of the configuration; can be given many times")
      ->type_name("SECTION.KEY=VALUE")
      ->allow_extra_args(false);
  app->add_option("--method", options->method, "Short for --set packing.method=METHOD")
      ->type_name("quasistatic|dynamic");
  CLI::Option* resume = app->add_flag(
      "--resume", options->resume,
      "Goes on from OUT.h5, to the same bits as an undisturbed run; [stop] and [output] may have "
      "changed, after exit code 3 [minimizer] and [insertion], too. Starts from the beginning if "
      "there is no OUT.h5, and returns at once if it is finished");
  app->add_flag("--force", options->force, "Replaces an existing OUT.h5")->excludes(resume);
  app->add_option("--log", options->log,
                  "Adds messages, summary and exit code to this file instead of printing them, the "
                  "table left out")
      ->type_name("FILE");
  app->add_flag("--dry-run", options->dry_run,
                "Prints the resolved configuration and an estimate, and writes nothing");
  app->add_option(
         "--threads", options->threads,
         "Threads to compute with, 1 by default; never changes a result. Large dense packings gain")
      ->type_name("N")
      ->check(CLI::Range(1, most_threads));
  app->footer(
      "Examples:\n"
      "  wirepack run data/scenarios/quickstart.toml -o quickstart.h5\n"
      "  wirepack run data/scenarios/quickstart.toml -o tight.h5 --set cavity.radius=8 --set "
      "packing.seed=2\n"
      "  wirepack run data/scenarios/quickstart.toml -o quickstart.h5 --resume\n"
      "  wirepack run data/scenarios/quickstart.toml --dry-run");
  return {app, [options] { return run(*options); }};
}

}  // namespace wirepack
