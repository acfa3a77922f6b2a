#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <vector>

#include "wirepack/core/error.hpp"
#include "wirepack/io/figure.hpp"
#include "wirepack/io/film.hpp"
#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/io/output_path.hpp"
#include "wirepack/io/sweep_folder.hpp"

#include "command.hpp"
#include "frame_choice.hpp"
#include "number_range.hpp"
#include "terminal.hpp"

namespace wirepack {

namespace {

struct Options {
  std::vector<std::string> results;
  std::string folder;
  std::optional<double> density;
  std::optional<std::int64_t> frame;
  PhiMaxThreshold threshold;
  bool film = false, force = false;
  std::size_t film_frames = 200;

  OutputRules rules() const { return {{results.begin(), results.end()}, force}; }
};

/// The frame that pictures show: the last one, or what was asked for.
PackingFrame chosen_frame(const Hdf5Reader& reader, const std::string& name,
                          const Options& options) {
  if (options.density) {
    return reader.frame(frame_at_density(reader, name, reader.history(), *options.density));
  }
  if (options.frame) return reader.frame(frame_of_increment(reader, name, *options.frame));
  return reader.frame(reader.frame_increments().back());
}

// The task of a sweep, or the name of the file.
std::string label_of(const std::filesystem::path& result) {
  const bool of_a_sweep = result.filename() == task_result_file && result.has_parent_path();
  return of_a_sweep ? result.parent_path().filename().string() : result.stem().string();
}

std::vector<FigureRun> read_runs(const std::vector<std::string>& results, const Options& options) {
  std::vector<FigureRun> runs;
  for (const std::string& result : results) {
    const Hdf5Reader reader(result);
    runs.push_back({label_of(result), reader.scenario(), reader.history(), {}});
    if (runs.back().history.empty() || reader.frame_increments().empty()) {
      throw FileError(result + ": holds no frame yet");
    }
    runs.back().frame = chosen_frame(reader, result, options);
  }
  return runs;
}

void make_film(const std::string& result, const Options& options) {
  const std::filesystem::path folder = options.folder;
  const bool video = draw_film(folder, Hdf5Reader(result), options.film_frames);
  print_lines((folder / "film" / "0001.png").string() + "\n");
  print_lines(video ? (folder / "film.mp4").string() + "\n"
                    : fmt::format("no film.mp4: there is no ffmpeg; elsewhere, in {}: {}\n",
                                  options.folder, film_command()));
}

/// A figure of an earlier call must not stand among those of this one.
void remove_figure(const std::filesystem::path& folder, const std::string& name) {
  for (const std::string& file : figure_files({name})) std::filesystem::remove(folder / file);
}

int draw(const Options& options) {
  const std::vector<std::string> results = results_named(options.results);
  const std::vector<FigureRun> runs = read_runs(results, options);
  std::vector<std::string> names{"packing",           "force",  "energy", "torsion",
                                 "bend_distribution", "phi_max"};
  output_folder(options.folder, figure_files(names), options.rules());
  const std::filesystem::path folder = options.folder;
  if (options.film) {
    output_folder(folder, {"film.mp4"}, options.rules());
    output_folder(folder / "film",
                  film_pictures(folder, Hdf5Reader(results.front()), options.film_frames),
                  options.rules());
  }
  draw_packing(folder, runs);
  draw_force(folder, runs);
  draw_energy(folder, runs);
  if (!draw_torsion(folder, runs)) {
    std::erase(names, "torsion");
    remove_figure(folder, "torsion");
    print_lines("no torsion, and no inset in energy: the runs have no torsional energy\n");
  }
  draw_bend_distribution(folder, runs);
  const PhiMaxFigure phi_max = draw_phi_max(folder, runs, options.threshold);
  if (phi_max == PhiMaxFigure::without_inset) {
    print_lines("no inset in phi_max: it takes runs in cavities of two radii\n");
  } else if (phi_max == PhiMaxFigure::none) {
    std::erase(names, "phi_max");
    remove_figure(folder, "phi_max");
    print_lines(
        fmt::format("no phi_max: no run reaches F R^2 / YI = {} from below after its first coil "
                    "(--threshold)\n",
                    options.threshold.scaled_force));
  }
  for (const std::string& name : names) print_lines((folder / (name + ".png")).string() + "\n");
  if (options.film) make_film(results.front(), options);
  return exit_done;
}

}  // namespace

Command figures_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "figures",
      "Figures of runs: pictures of the first of each setup, curves and distributions of all");
  const auto options = std::make_shared<Options>();
  app->add_option("RESULT.h5", options->results, "Results of wirepack run, or folders of sweeps")
      ->required();
  app->add_option("-o,--output", options->folder,
                  "Folder for PNG, PDF, SVG and the data behind them")
      ->required()
      ->type_name("DIR");
  CLI::Option* density = app->add_option("--density", options->density,
                                         "Shows the frame nearest to this packing density")
                             ->type_name("PHI")
                             ->check(number_range(0, 1));
  app->add_option("--frame", options->frame, "Shows the frame of this increment")
      ->type_name("INCREMENT")
      ->excludes(density);
  app->add_option("--threshold", options->threshold.scaled_force,
                  "F R^2 / YI at which phi_max is read")
      ->type_name("FORCE")
      ->check(number_range(1e-3, 1e6))
      ->capture_default_str();
  app->add_option(
         "--mean-over", options->threshold.fed_over_radius,
         "phi_max is read from the mean force over so many radii of the cavity of wire fed "
         "last, or over an edge where that is longer")
      ->type_name("RADII")
      ->check(number_range(0, 1e3))
      ->capture_default_str();
  CLI::Option* film = app->add_flag(
      "--film", options->film,
      "A film of the first run, too: DIR/film/0001.png and so on, and DIR/film.mp4 by ffmpeg");
  app->add_option("--frames", options->film_frames,
                  "With --film: at most so many of the saved frames, evenly spread")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, std::size_t{9999}))
      ->capture_default_str()
      ->needs(film);
  app->add_flag("--force", options->force, "Replaces figures that are there");
  app->footer(
      "Examples:\n  wirepack figures quickstart.h5 -o figures\n"
      "  wirepack figures radii-and-seeds/ -o figures --threshold 15");
  return {app, [options] { return draw(*options); }};
}

}  // namespace wirepack
