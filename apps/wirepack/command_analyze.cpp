#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <vector>

#include "wirepack/core/error.hpp"
#include "wirepack/io/hdf5_reader.hpp"

#include "analysis.hpp"
#include "command.hpp"
#include "frame_choice.hpp"
#include "number_range.hpp"
#include "terminal.hpp"

namespace wirepack {

namespace {

struct Options {
  std::vector<std::string> results;
  std::vector<double> densities;
  bool json = false, csv = false;
};

/// Folders stand for the results in them, in order of their names.
std::vector<std::string> result_files(const std::vector<std::string>& given) {
  std::vector<std::string> files;
  for (const std::string& name : given) {
    std::error_code error;
    if (!std::filesystem::is_directory(name, error)) {
      files.push_back(name);
      continue;
    }
    std::vector<std::string> inside;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(name, error)) {
      if (entry.path().extension() == ".h5") inside.push_back(entry.path().string());
    }
    if (error) throw FileError(name + ": " + error.message());
    if (inside.empty()) throw FileError(name + ": holds no .h5 file");
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

/// The last frame, or those nearest to the densities. Tells on stderr which densities the run has
/// not.
AnalysedRun analyse(const std::string& file, const std::vector<double>& densities) {
  const Hdf5Reader reader(file);
  const std::vector<std::int64_t> frames = reader.frame_increments();
  if (frames.empty()) throw FileError(file + ": holds no frame yet");
  const std::vector<HistoryRow> history = reader.history();
  AnalysedRun run{file, reader.scenario(), {}, {}};
  run.levels = level_densities(run.scenario, history);
  const auto observe = [&](std::int64_t increment) {
    PackingFrame frame = reader.frame(increment);
    if (frame.rod.edge_count() > 5000) {
      print_message(fmt::format("{}: all pairs of {} edges ...", file, frame.rod.edge_count()));
    }
    run.frames.push_back(observe_frame(
        file, run.scenario, row_of_increment(history, file, increment), std::move(frame)));
  };
  if (densities.empty()) observe(frames.back());
  for (const double density : densities) {
    try {
      observe(frame_at_density(reader, file, history, density));
    } catch (const InvalidInput& beyond) {
      print_message(beyond.what());
    }
  }
  return run;
}

int analyze(const Options& options) {
  std::vector<AnalysedRun> runs;
  bool empty = true;
  for (const std::string& file : result_files(options.results)) {
    runs.push_back(analyse(file, options.densities));
    empty = empty && runs.back().frames.empty();
  }
  if (empty) throw InvalidInput("--density: no run has a frame there");
  print_lines(options.json  ? analysis_json(runs)
              : options.csv ? analysis_csv(runs)
                            : analysis_table(runs));
  return exit_done;
}

}  // namespace

Command analyze_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "analyze", "Order, layers, contacts, knots, energies of frames; phi_max; means over seeds");
  app->set_help_flag("--help,-h", "This help");
  const auto options = std::make_shared<Options>();
  app->add_option("RESULT.h5", options->results, "Results of wirepack run, or folders of them")
      ->required();
  app->add_option("--density", options->densities,
                  "The frames nearest to these packing densities instead of the last one; says so "
                  "where a run has none")
      ->type_name("PHI[,PHI]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(number_range(0, 1));
  CLI::Option* json =
      app->add_flag("--json", options->json, "All numbers, profiles and contacts, with all digits");
  app->add_flag("--csv", options->csv, "A line of numbers for each frame, with all digits")
      ->excludes(json);
  app->footer(
      "Formula and source of each number: data/docs/observables.md. Runs of one scenario that\n"
      "differ in the seed are averaged, runs in different cavities fitted by a power law.\n"
      "Examples: wirepack analyze quickstart.h5\n"
      "          wirepack analyze low.h5 high.h5 --density 0.1,0.2,0.3 --json\n"
      "          wirepack analyze sweep --csv");
  return {app, [options] { return analyze(*options); }};
}

}  // namespace wirepack
