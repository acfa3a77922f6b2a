#pragma once

#include <cstdint>
#include <string>

namespace wirepack {

struct Colour {
  std::uint8_t red = 255, green = 255, blue = 255;
};

/// The colours in which pictures and meshes of a packing show a number, from blue over sand to red;
/// `share` of their range, 0 to 1, beyond which the last colours stay.
Colour palette_colour(double share);

/// The same palette as a command of gnuplot.
std::string gnuplot_palette();

}  // namespace wirepack
