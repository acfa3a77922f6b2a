#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <vector>

#include "wirepack/core/error.hpp"
#include "wirepack/io/figure.hpp"
#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/io/output_path.hpp"
#include "wirepack/io/sweep_folder.hpp"

#include "command.hpp"
#include "frame_choice.hpp"
#include "terminal.hpp"

namespace wirepack {

namespace {

struct Options {
  std::vector<std::string> results;
  std::string folder;
  std::optional<double> density;
  std::optional<std::int64_t> frame;
  double threshold = 10;
  bool force = false;
};

/// The frame that pictures show: the last one, or what was asked for.
PackingFrame chosen_frame(const Hdf5Reader& reader, const std::string& name,
                          const Options& options) {
  const std::vector<std::int64_t> frames = reader.frame_increments();
  if (options.density) {
    return reader.frame(frame_at_density(reader, name, reader.history(), *options.density));
  }
  if (!options.frame) return reader.frame(frames.back());
  if (std::find(frames.begin(), frames.end(), *options.frame) == frames.end()) {
    throw InvalidInput(fmt::format("--frame {}: {} has frames of increments {} to {}",
                                   *options.frame, name, frames.front(), frames.back()));
  }
  return reader.frame(*options.frame);
}

// The task of a sweep, or the name of the file.
std::string label_of(const std::filesystem::path& result) {
  const bool of_a_sweep = result.filename() == task_result_file && result.has_parent_path();
  return of_a_sweep ? result.parent_path().filename().string() : result.stem().string();
}

int draw(const Options& options) {
  std::vector<std::string> names{"packing", "section",           "force",  "energy",
                                 "torsion", "bend_distribution", "phi_max"};
  output_folder(options.folder, figure_files(names),
                {{options.results.begin(), options.results.end()}, options.force});
  std::vector<FigureRun> runs;
  for (const std::string& result : results_named(options.results)) {
    const Hdf5Reader reader(result);
    runs.push_back({label_of(result), reader.scenario(), reader.history(), {}});
    if (runs.back().history.empty() || reader.frame_increments().empty()) {
      throw FileError(result + ": holds no frame yet");
    }
    runs.back().frame = chosen_frame(reader, result, options);
  }
  const std::filesystem::path folder = options.folder;
  draw_packing(folder, runs.front().scenario, runs.front().frame);
  draw_section(folder, runs.front().scenario, runs.front().frame);
  draw_force(folder, runs);
  draw_energy(folder, runs);
  draw_torsion(folder, runs);
  draw_bend_distribution(folder, runs);
  if (!draw_phi_max(folder, runs, options.threshold)) {
    std::erase(names, "phi_max");
    print_lines(fmt::format("no phi_max: no run reaches F R^2 / YI = {} (--threshold)\n",
                            options.threshold));
  }
  for (const std::string& name : names) print_lines((folder / (name + ".png")).string() + "\n");
  return exit_done;
}

}  // namespace

Command figures_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "figures",
      "Figures of runs: packing and section of the first, curves and distributions of all");
  const auto options = std::make_shared<Options>();
  app->add_option("RESULT.h5", options->results, "Results of wirepack run, or folders of sweeps")
      ->required();
  app->add_option("-o,--output", options->folder,
                  "Folder for PNG, PDF, SVG and the data behind them")
      ->required();
  CLI::Option* density = app->add_option("--density", options->density,
                                         "Shows the frame nearest to this packing density")
                             ->check(CLI::Range(0.0, 1.0));
  app->add_option("--frame", options->frame, "Shows the frame of this increment")
      ->excludes(density);
  app->add_option("--threshold", options->threshold, "F R^2 / YI at which phi_max is read")
      ->check(CLI::Range(1e-3, 1e6))
      ->capture_default_str();
  app->add_flag("--force", options->force, "Replaces figures that are there");
  app->footer(
      "Examples:\n  wirepack figures quickstart.h5 -o figures\n"
      "  wirepack figures radii-and-seeds/ -o figures --threshold 15");
  return {app, [options] { return draw(*options); }};
}

}  // namespace wirepack
