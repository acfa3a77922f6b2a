#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string_view>
#include <vector>

#include "wirepack/core/error.hpp"
#include "wirepack/io/comparison_page.hpp"
#include "wirepack/io/config_file.hpp"
#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/io/output_path.hpp"
#include "wirepack/io/recorded_run.hpp"
#include "wirepack/io/view_page.hpp"
#include "wirepack/packing/longest_wire.hpp"
#include "wirepack/packing/warnings.hpp"

#include "command.hpp"
#include "run_advice.hpp"
#include "run_display.hpp"
#include "stop_signals.hpp"
#include "terminal.hpp"

namespace wirepack {

namespace {

struct Options {
  std::string config, folder, command_line;
  std::vector<std::string> assignments;
  double density = 0.2;
  int seeds = 1;
  bool page = false, force = false;
};

void say(const std::string& message) { print_message("wirepack compare: " + message); }

std::vector<ConfigOverride> overrides_of(const Options& options) {
  std::vector<ConfigOverride> overrides;
  for (const std::string& assignment : options.assignments) {
    overrides.push_back({assignment, "--set " + assignment});
  }
  return overrides;
}

// The configuration that all ways share.
Configuration configuration_of(const Options& options) {
  Configuration config = read_configuration(options.config, overrides_of(options));
  Scenario& scenario = config.scenario;
  scenario.stop = {};
  scenario.stop.density = options.density;
  std::string text;
  for (const auto& [way, name] : ways) {
    for (const std::string& problem : problems(scenario_of(way, scenario))) {
      if (text.find(problem) == std::string::npos) text += (text.empty() ? "" : "\n") + problem;
    }
  }
  constexpr std::string_view key = "stop.density";  // which --density sets
  if (text.starts_with(key)) text.replace(0, key.size(), "--density");
  if (!text.empty()) throw InvalidInput(text);
  if (compared_densities(scenario, options.density).empty()) {
    throw InvalidInput(fmt::format(
        "--density {}: must be at least {}, the first density to compare at beyond a length of "
        "4 R, where the wire has curled up",
        options.density, compared_densities(scenario, 1).front()));
  }
  return config;
}

/// Runs one way to its end, going on from a file that is there: one that has reached its density
/// goes on to a larger one, one that was lost stays so. False: a signal has stopped it.
bool run(const Scenario& scenario, const std::filesystem::path& file, const Options& options) {
  RunDisplay display(scenario, nullptr);
  RunHooks hooks = display.hooks();
  hooks.say = say;
  try {
    return run_recorded(scenario, file,
                        {.existing = Existing::go_on, .command_line = options.command_line}, hooks)
        .stop.has_value();
  } catch (const InvalidInput& error) {  // the scenario is valid, so it is not that of the file
    throw InvalidInput(std::string(error.what()) + "; give another folder");
  }
}

ComparedRun read_run(Way way, const std::filesystem::path& file) {
  const Hdf5Reader reader(file);
  ComparedRun run{way, reader.scenario(), reader.history(), {}};
  for (const std::int64_t increment : reader.frame_increments()) {
    run.frames.push_back(reader.frame(increment));
  }
  return run;
}

// The run of the first seed is found under the name that it has with one seed, and with several.
std::string run_file(const Options& options, const Scenario& seeded, std::uint64_t first_seed,
                     std::string_view name) {
  const std::string single = fmt::format("{}.h5", name);
  const std::string several = fmt::format("{}_seed{}.h5", name, seeded.seed);
  const std::filesystem::path folder = options.folder;
  if (seeded.seed != first_seed) return several;
  if (options.seeds == 1) return exists(folder / several) ? several : single;
  return exists(folder / single) ? single : several;
}

// The page of a run lies beside it.
std::string page_of(const std::filesystem::path& run) { return run.stem().string() + ".html"; }

int compare_ways(const Options& options) {
  const Configuration config = configuration_of(options);
  const Scenario& scenario = config.scenario;
  const std::vector<std::filesystem::path>& inputs = config.inputs;
  const std::filesystem::path folder = options.folder;
  // beside runs that are gone on with, page and figures are those of an earlier call
  const bool begun =
      std::filesystem::exists(folder / run_file(options, scenario, scenario.seed, ways[0].second));
  std::vector<std::string> outputs = comparison_files();
  if (options.page) {
    for (const auto& [way, name] : ways) {
      outputs.push_back(page_of(run_file(options, scenario, scenario.seed, name)));
    }
  }
  output_folder(folder, outputs, {inputs, options.force || begun});
  make_folder(folder);
  say_warnings("compare", warnings(scenario, expected_length(scenario)));
  catch_stop_signals();
  std::vector<ComparedRun> runs;
  std::vector<RunPage> pages;
  for (int k = 0; k < options.seeds; ++k) {
    Scenario seeded = scenario;
    seeded.seed += static_cast<std::uint64_t>(k);
    for (const auto& [way, name] : ways) {
      // a run that is there is gone on with
      const std::filesystem::path file =
          output_file(folder / run_file(options, seeded, scenario.seed, name),
                      {.inputs = inputs, .force = true});
      say(fmt::format("{}, seed {}", name, seeded.seed));
      if (!run(scenario_of(way, seeded), file, options)) {
        say("stopped by a signal; the same command goes on from there");
        return exit_stopped_by_signal;
      }
      runs.push_back(read_run(way, file));
      if (options.page) {
        pages.push_back({fmt::format("{}, seed {}", name, seeded.seed), page_of(file)});
        update_view_page(file, folder / pages.back().file);
      }
    }
  }
  const Comparison comparison = compare(runs);
  write_comparison(
      folder,
      {std::filesystem::path(options.config).filename().string(), resolved_config(scenario), pages},
      runs, comparison);
  std::fputs(comparison_table(comparison).c_str(), stdout);
  print_lines(fmt::format("# {}\n", (folder / "comparison.html").string()));
  return exit_done;
}

}  // namespace

Command compare_command(CLI::App& program, const std::string& command_line) {
  auto options = std::make_shared<Options>();
  options->command_line = command_line;
  CLI::App* app = program.add_subcommand(
      "compare", "Minimization and integration in time of one scenario, with and without friction");
  app->set_help_flag("--help,-h", "This help");
  app->add_option("CONFIG.toml", options->config,
                  "Configuration; its method, model of friction and limits do not count")
      ->required();
  app->add_option(
         "-o,--output", options->folder,
         "Folder for the runs, the page, the figures and the JSON; runs that are there are "
         "gone on with")
      ->required()
      ->type_name("DIR");
  app->add_option("--density", options->density, "Packing density to which all ways are run")
      ->type_name("PHI")
      ->capture_default_str();
  app->add_option("--seeds", options->seeds, "Runs of each way, with successive seeds")
      ->type_name("N")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app->add_flag("--page", options->page,
                "A page of each run, too, as of wirepack view, to which comparison.html leads");
  app->add_flag("--force", options->force,
                "Replaces a page, figures and JSON that are there without their runs");
  app->add_option("--set", options->assignments, "Sets a key, as section.key=value")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  app->footer("Example: wirepack compare data/scenarios/low_torsion_r5.toml -o compare_r5");
  return {app, [options] { return compare_ways(*options); }};
}

}  // namespace wirepack
