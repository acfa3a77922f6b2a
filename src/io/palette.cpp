#include "palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace wirepack {

namespace {

struct Stop {
  double share, red, green, blue;
};
constexpr std::array<Stop, 4> stops{{{0, 0x2B, 0x5C, 0x8A},
                                     {0.35, 0x6F, 0xB1, 0xC8},
                                     {0.6, 0xF2, 0xE2, 0xB0},
                                     {1, 0xB5, 0x34, 0x2C}}};

}  // namespace

Colour palette_colour(double share) {
  share = std::clamp(share, 0.0, 1.0);
  std::size_t k = 0;
  while (k + 2 < stops.size() && share > stops[k + 1].share) ++k;
  const double part = (share - stops[k].share) / (stops[k + 1].share - stops[k].share);
  const auto mixed = [&](double Stop::*channel) {
    const double from = stops[k].*channel, to = stops[k + 1].*channel;
    return static_cast<std::uint8_t>(std::lround(from + part * (to - from)));
  };
  return {mixed(&Stop::red), mixed(&Stop::green), mixed(&Stop::blue)};
}

std::string gnuplot_palette() {
  std::string text;
  for (const Stop& stop : stops) {
    text += fmt::format("{}{} '#{:02x}{:02x}{:02x}'", text.empty() ? "" : ", ", stop.share,
                        int(stop.red), int(stop.green), int(stop.blue));
  }
  return "set palette defined (" + text + ")\n";
}

}  // namespace wirepack
