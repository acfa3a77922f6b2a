#include "wirepack/io/film.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <system_error>

#include "wirepack/core/error.hpp"
#include "wirepack/io/output_path.hpp"

#include "atomic_file.hpp"
#include "child_program.hpp"
#include "drawing_folder.hpp"
#include "frame_spread.hpp"
#include "packing_figure.hpp"

namespace wirepack {

namespace fs = std::filesystem;

namespace {

// H.264 of these colours needs even sizes, which an even width of a view gives.
constexpr int view_width = 720;

std::vector<std::string> ffmpeg_words(const std::string& pictures) {
  return {"ffmpeg", "-nostdin", "-loglevel", "error",    "-framerate", "12",      "-i",
          pictures, "-c:v",     "libx264",   "-pix_fmt", "yuv420p",    "film.mp4"};
}

std::string picture_name(std::size_t k) { return fmt::format("{:04}.png", k + 1); }

std::string caption(const Scenario& scenario, const PackingFrame& frame) {
  return fmt::format("{}, F R²/YI = {:.2f}", packing_caption(scenario, frame),
                     frame.force / units_of(scenario).scaled_force());
}

void remove_file(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error) throw FileError(file.string() + ": cannot be removed: " + error.message());
}

bool is_picture(const fs::path& file) {
  const std::string stem = file.stem().string();
  return file.extension() == ".png" && stem.size() == 4 &&
         std::all_of(stem.begin(), stem.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::vector<std::string> earlier_pictures(const fs::path& folder) {
  std::vector<std::string> names;
  if (!fs::is_directory(folder)) return names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (is_picture(entry.path())) names.push_back(entry.path().filename().string());
  }
  return names;
}

void remove_earlier_film(const fs::path& folder) {
  remove_file(folder / "film.mp4");
  for (const std::string& name : earlier_pictures(folder / "film")) {
    remove_file(folder / "film" / name);
  }
}

double highest_colour(const Hdf5Reader& reader, const std::vector<std::int64_t>& frames) {
  double top = 0;
  for (const std::int64_t frame : frames) {
    top = std::max(top, top_of_colours(reader.scenario(), reader.frame(frame)));
  }
  return top;
}

bool make_video(const fs::path& folder) {
  const DrawingFolder made(folder);
  const std::optional<int> code = run_child_program(made.path(), ffmpeg_words("../film/%04d.png"));
  if (!code) return false;
  const fs::path video = made.path() / "film.mp4";
  if (*code != 0 || !fs::exists(video)) {
    throw FileError(fmt::format("{}: not made: ffmpeg ended with code {}; its pictures are in {}",
                                (folder / "film.mp4").string(), *code, (folder / "film").string()));
  }
  replace_file(folder / "film.mp4", read_bytes(video));
  return true;
}

}  // namespace

std::vector<std::string> film_pictures(const fs::path& folder, const Hdf5Reader& reader,
                                       std::size_t most_frames) {
  std::vector<std::string> names = earlier_pictures(folder / "film");
  for (std::size_t k = 0; k < std::min(most_frames, reader.frame_increments().size()); ++k) {
    names.push_back(picture_name(k));
  }
  return names;
}

std::string film_command() {
  return fmt::format("{}", fmt::join(ffmpeg_words("film/%04d.png"), " "));
}

bool draw_film(const fs::path& folder, const Hdf5Reader& reader, std::size_t most_frames) {
  make_folder(folder / "film");
  remove_earlier_film(folder);
  const Scenario scenario = reader.scenario();
  const std::vector<std::int64_t> frames = spread(reader.frame_increments(), most_frames);
  const double top = highest_colour(reader, frames);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const PackingFrame frame = reader.frame(frames[k]);
    draw_png(folder / "film" / picture_name(k),
             packing_drawing({{&scenario, &frame, caption(scenario, frame)}}, top, view_width));
  }
  return make_video(folder);
}

}  // namespace wirepack
