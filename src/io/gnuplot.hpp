#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wirepack {

inline constexpr const char* density_axis = "set xlabel 'packing density φ'\n";

// Pixels of a PNG; PDF and SVG have its shape, and a PDF 14 cm to 1200 of them.
struct Canvas {
  int width, height;
};

// A file that the commands of a drawing read beside its data.
struct DrawingPart {
  std::string name, bytes;
};

// What gnuplot draws: `commands` read NAME.dat, which holds `data`, and the parts.
struct Drawing {
  std::string name, data, commands;
  Canvas canvas;
  std::vector<DrawingPart> parts;
};

// A title that gnuplot shows to the letter, with the word `title`.
std::string gnuplot_title(const std::string& text);

// A text that gnuplot shows to the letter, in quotes.
std::string gnuplot_text(const std::string& text);

// Draws NAME.png, NAME.pdf and NAME.svg in the folder, and keeps the script, NAME.gp, its data and
// parts beside them. Each file is replaced as a whole. Throws FileError where something cannot be
// written, or gnuplot fails or is missing.
void draw_with_gnuplot(const std::filesystem::path& folder, const Drawing& drawing);

// Draws a PNG alone. Throws as draw_with_gnuplot() does.
void draw_png(const std::filesystem::path& png, const Drawing& drawing);

}  // namespace wirepack
