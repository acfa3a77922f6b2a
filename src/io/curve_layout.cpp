#include "curve_layout.hpp"

#include <cmath>
#include <fmt/format.h>

namespace wirepack {

namespace {

// Pixels.
constexpr int left = 150, right = 1170, above = 25, graph_height = 720, labels = 115, key_line = 34,
              below = 20;

// The fifth colour of gnuplot, yellow, cannot be seen on white.
constexpr const char* style =
    "set linetype 5 lc rgb '#8c564b'\nset border 3\nset tics nomirror\nset grid lc rgb '#dddddd'\n";

std::string margins(double left_share, double right_share, double bottom_share, double top_share) {
  return fmt::format(
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n"
      "set tmargin at screen {:.5f}\n",
      left_share, right_share, bottom_share, top_share);
}

}  // namespace

double tic_step(double range, int most) {
  const double power = std::pow(10.0, std::floor(std::log10(range / most)));
  const double part = range / most / power;
  return power * (part > 5 ? 10 : part > 2 ? 5 : part > 1 ? 2 : 1);
}

CurveLayout::CurveLayout(std::size_t key_lines)
    : canvas_{1200,
              above + graph_height + labels + static_cast<int>(key_lines) * key_line + below} {}

std::string CurveLayout::graph() const {
  const double height = canvas_.height, bottom = height - above - graph_height;
  return style + margins(left / 1200.0, right / 1200.0, bottom / height, 1 - above / height) +
         fmt::format("set key at screen 0.5,{:.5f} center top Left reverse maxcols 1\n",
                     (bottom - labels) / height);
}

std::string CurveLayout::inset(const Box& box) const {
  const double height = canvas_.height, bottom = height - above - graph_height;
  const auto across = [](double share) { return (left + share * (right - left)) / 1200; };
  const auto up = [&](double share) { return (bottom + share * graph_height) / height; };
  // beside it stand the numbers of its axes
  const double room_left = 0.14, room_below = 0.13, room = 0.015;
  return style +
         margins(across(box.left + room_left), across(box.right - room),
                 up(box.bottom + room_below), up(box.top - room)) +
         fmt::format(
             "set object 9 rectangle from screen {:.5f},{:.5f} to screen {:.5f},{:.5f} behind "
             "fs solid noborder fc rgb 'white'\nunset key\nset tics font small\n"
             "set xlabel font small offset 0,0.5\nset ylabel font small offset 1,0\n",
             across(box.left), up(box.bottom), across(box.right), up(box.top));
}

}  // namespace wirepack
