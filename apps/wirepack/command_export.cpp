#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <system_error>

#include "wirepack/core/error.hpp"
#include "wirepack/io/export.hpp"
#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/io/output_path.hpp"

#include "command.hpp"
#include "frame_choice.hpp"
#include "number_range.hpp"
#include "terminal.hpp"

namespace wirepack {

namespace {

enum class Frames { none, one, all };

struct ExportFormat {
  std::string_view name, ending;
  Frames frames;  ///< what it holds unless a frame is chosen
  ExportedFiles (*files)(const ExportSource&);
  std::string_view meaning;
};

constexpr std::array<ExportFormat, 9> formats{{
    {"vtk", ".pvd", Frames::all, export_vtk,
     "ParaView, VTK, PyVista: lines with numbers at the nodes, a .vtp file per frame"},
    {"xdmf", ".xdmf", Frames::all, export_xdmf,
     "ParaView: opens the frames inside of RESULT.h5, which must stay where it is"},
    {"xyz", ".xyz", Frames::all, export_xyz, "OVITO, ASE: extended XYZ, a particle per node"},
    {"stl", ".stl", Frames::one, export_stl, "CAD, slicers: closed surface"},
    {"ply", ".ply", Frames::one, export_ply, "Blender, MeshLab: closed surface, coloured"},
    {"3mf", ".3mf", Frames::one, export_3mf, "CAD, slicers: beam lattice of nodes and radii"},
    {"mhd", ".mhd", Frames::one, export_voxels, "CT programs, ITK: voxels of the solid fraction"},
    {"mmcif", ".cif", Frames::one, export_mmcif, "ChimeraX, Mol*: a bead per node"},
    {"csv", ".csv", Frames::none, export_csv, "the history, one row per increment"},
}};

struct Options {
  std::string result, format, output;
  std::optional<std::int64_t> frame;
  std::optional<double> density, voxel_size;
  bool force = false;
};

const ExportFormat& format_of(const Options& options) {
  const auto* format = std::find_if(formats.begin(), formats.end(), [&](const ExportFormat& known) {
    return known.name == options.format;
  });
  const std::filesystem::path target = options.output;
  if (target.extension() != format->ending || !target.has_stem()) {
    throw InvalidInput(fmt::format("-o {}: the name must end in {} for the format {}",
                                   options.output, format->ending, format->name));
  }
  const bool chosen = options.frame || options.density;
  if (chosen && format->frames == Frames::none) {
    throw InvalidInput("--frame, --density: the history has no frames to choose from");
  }
  if (options.voxel_size && format->files != export_voxels) {
    throw InvalidInput("--voxel: only the format mhd has voxels");
  }
  return *format;
}

std::vector<std::int64_t> chosen_frames(const Hdf5Reader& reader, const Options& options,
                                        Frames wanted) {
  if (wanted == Frames::none) return {};
  const std::vector<std::int64_t> frames = reader.frame_increments();
  if (frames.empty()) throw FileError(options.result + ": holds no frame yet");
  if (options.frame) return {frame_of_increment(reader, options.result, *options.frame)};
  if (options.density) {
    return {frame_at_density(reader, options.result, reader.history(), *options.density)};
  }
  if (wanted == Frames::one) return {frames.back()};
  return frames;
}

/// Leads every file to its place; folders that are not there yet have nothing to lose.
void place(ExportedFiles& files, const OutputRules& rules) {
  for (ExportedFile& file : files) {
    const std::filesystem::path folder = file.path.parent_path();
    std::error_code error;
    if (!folder.empty() && !std::filesystem::exists(folder, error)) continue;
    file.path = output_file(file.path, rules);
  }
}

int write_export(const Options& options) {
  const ExportFormat& format = format_of(options);
  const OutputRules rules{{options.result}, options.force};
  output_file(options.output, rules);
  const Hdf5Reader reader(options.result);
  ExportSource source = export_source(reader, options.result, options.output,
                                      chosen_frames(reader, options, format.frames));
  if (source.history.empty()) throw FileError(options.result + ": holds no increment yet");
  source.voxel_size = options.voxel_size;
  ExportedFiles files = format.files(source);
  place(files, rules);
  write_files(files);
  print_lines(options.output + "\n");
  return exit_done;
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const ExportFormat& format : formats) names.emplace_back(format.name);
  return names;
}

std::string format_table() {
  std::string text = "Formats:\n";
  for (const ExportFormat& format : formats) {
    const std::string_view of = format.frames == Frames::all   ? "all frames"
                                : format.frames == Frames::one ? "last frame"
                                                               : "";
    text +=
        fmt::format("  {:5}  {:5}  {:10}  {}\n", format.name, format.ending, of, format.meaning);
  }
  return text;
}

}  // namespace

Command export_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("export", "A result for ParaView, OVITO, CAD, CT programs and others");
  app->set_help_flag("--help,-h", "This help");
  const auto options = std::make_shared<Options>();
  app->add_option("RESULT.h5", options->result, "Result of wirepack run")->required();
  app->add_option("--format", options->format, "One of the formats below")
      ->required()
      ->type_name("FORMAT")
      ->check(CLI::IsMember(format_names()).description(""));
  app->add_option("-o,--output", options->output, "File to write")->required()->type_name("PATH");
  CLI::Option* frame =
      app->add_option("--frame", options->frame, "Only the frame of this increment")
          ->type_name("INCREMENT");
  app->add_option("--density", options->density, "Only the frame nearest to this packing density")
      ->type_name("PHI")
      ->check(number_range(0, 1))
      ->excludes(frame);
  app->add_option("--voxel", options->voxel_size,
                  "Edge of a voxel, for mhd; by default a quarter of the wire radius, or R / 128 "
                  "if that is larger")
      ->type_name("LENGTH")
      ->check(CLI::PositiveNumber);
  app->add_flag("--force", options->force, "Replaces what exists");
  app->footer(format_table() +
              "Numbers are in the units of the configuration. Pages: data/docs/export.md\n"
              "Examples: wirepack export quickstart.h5 --format vtk -o quickstart.pvd\n"
              "          wirepack export quickstart.h5 --format 3mf --density 0.1 -o wire.3mf");
  return {app, [options] { return write_export(*options); }};
}

}  // namespace wirepack
