#pragma once

#include <filesystem>
#include <string>

namespace wirepack {

// Axes, grid and key of curves against the packing density.
inline constexpr const char* curve_style =
    "set xlabel 'packing density {/Symbol f}'\nset key below Left reverse maxcols 1\n"
    "set grid lc rgb '#dddddd'\nset border 3\nset tics nomirror\n";

inline constexpr const char* curve_size = "14cm,12cm";
inline constexpr const char* curve_pixels = "1200,1030";

// A title that gnuplot shows to the letter, with the word `title`.
std::string gnuplot_title(const std::string& text);

// Draws NAME.png, NAME.pdf and NAME.svg in the folder by these commands, and keeps the script and
// its data, NAME.dat, beside them. `size` is that of the PDF, `pixels` that of the PNG. Each file
// is replaced as a whole. Throws FileError where something cannot be written, or gnuplot fails or
// is missing.
void draw_with_gnuplot(const std::filesystem::path& folder, const std::string& name,
                       const std::string& data, const std::string& commands,
                       const std::string& size, const std::string& pixels);

}  // namespace wirepack
