#include "packing_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "wirepack/core/plain_text.hpp"
#include "wirepack/io/figure.hpp"

#include "node_values.hpp"
#include "setup_name.hpp"
#include "wire_picture.hpp"

namespace wirepack {

namespace {

// Half the width of a view, over the cavity's largest semi-axis: room for what presses on the wall.
constexpr double room = 1.05;

// From above one side, as a viewer holds a ball.
Camera outside(const Cavity& cavity) {
  const double tilt = 65 * pi / 180, turn = 30 * pi / 180;
  return {Vec3(std::cos(turn), std::sin(turn), 0),
          Vec3(-std::sin(turn) * std::cos(tilt), std::cos(turn) * std::cos(tilt), std::sin(tilt)),
          room * semi_axes_of(cavity).maxCoeff(), std::nullopt};
}

// Along y, what lies nearer than the plane y = 0 cut away.
Camera cut(const Cavity& cavity) {
  return {Vec3::UnitX(), Vec3::UnitZ(), room * semi_axes_of(cavity).maxCoeff(), 0.0};
}

// Where the wall is seen edge-on: an ellipsoid is a sphere of radius 1 along its axes, and turns
// that circle to one across the shrunk line of sight. In half widths of the view, about `middle`.
std::string outline(const Cavity& cavity, const Camera& camera, const Eigen::Vector2d& middle) {
  const Vec3 axes = semi_axes_of(cavity);
  const Vec3 sight = camera.right.cross(camera.up).cwiseQuotient(axes).normalized();
  const Vec3 first = sight.unitOrthogonal(), second = sight.cross(first);
  std::string text;
  for (int k = 0; k <= 120; ++k) {
    const Vec3 r =
        axes.cwiseProduct(std::cos(pi * k / 60) * first + std::sin(pi * k / 60) * second);
    text += fmt::format("{:.4f} {:.4f}\n", middle.x() + r.dot(camera.right) / camera.half_width,
                        middle.y() + r.dot(camera.up) / camera.half_width);
  }
  return text + "\n";
}

// Centrelines of the runs, a block each.
std::string node_table(const std::vector<ShownPacking>& shown) {
  std::string text;
  for (const ShownPacking& run : shown) {
    const Points& nodes = run.frame->rod.nodes;
    const Eigen::VectorXd colour = scaled_bend_energy(*run.scenario, *run.frame);
    text += fmt::format("# {}, wire radius {}\n# x y z bending_energy_per_length/(YI/2R^2)\n",
                        plain_text(run.caption), run.scenario->wire.radius);
    for (Index i = 0; i < nodes.cols(); ++i) {
      text += fmt::format("{:.6g} {:.6g} {:.6g} {:.4g}\n", nodes(0, i), nodes(1, i), nodes(2, i),
                          colour[i]);
    }
    text += "\n\n";
  }
  return text;
}

// In pieces of half a radius, with which a wire looks round, or a few thousand.
SmoothLine shown_line(const ShownPacking& run, double top) {
  const Points& nodes = run.frame->rod.nodes;
  const double edge = (nodes.col(1) - nodes.col(0)).norm() / run.scenario->wire.radius;
  const Index parts = std::min<Index>(std::lround(2 * edge), 6000 / nodes.cols());
  return smooth_line(nodes, scaled_bend_energy(*run.scenario, *run.frame) / top,
                     std::clamp<Index>(parts, 1, 4));
}

// The two views of a run: beside each other where it is the only one, else one above the other.
struct View {
  int column, row;
};
std::array<View, 2> views_of(std::size_t run, std::size_t runs) {
  const int k = static_cast<int>(run);
  return runs == 1 ? std::array<View, 2>{{{0, 0}, {1, 0}}} : std::array<View, 2>{{{k, 0}, {k, 1}}};
}

constexpr int columns = 2;

std::string layout(const Canvas& canvas, int top_margin, int rows, int width) {
  const double high = canvas.height, bottom = high - top_margin - rows * width;
  return fmt::format(
      "unset border\nunset tics\nunset key\n"
      "set lmargin at screen 0\nset rmargin at screen 1\n"
      "set tmargin at screen {:.6f}\nset bmargin at screen {:.6f}\n"
      "set xrange [-1:{}]\nset yrange [{}:1]\n"
      "set colorbox horizontal user origin 0.25,{:.6f} size 0.5,{:.6f}\nset cbtics\n"
      "set cblabel 'bending energy per length / (YI / 2R^2)'\n",
      1 - top_margin / high, bottom / high, 2 * columns - 1, 1 - 2 * rows, 0.72 * bottom / high,
      0.12 * bottom / high);
}

}  // namespace

std::string packing_caption(const Scenario& scenario, const PackingFrame& frame) {
  return fmt::format("{}, R = {:.3g} a, φ = {:.3f}", setup_name(scenario.setup),
                     scenario.cavity.radius / scenario.wire.radius, frame.packing_density);
}

double top_of_colours(const Scenario& scenario, const PackingFrame& frame) {
  return top_of_colours(scaled_bend_energy(scenario, frame));
}

Drawing packing_drawing(const std::vector<ShownPacking>& shown, double top, int width) {
  const int rows = shown.size() == 1 ? 1 : 2, top_margin = 60, bottom_margin = 140;
  const Canvas canvas{columns * width, rows * width + top_margin + bottom_margin};
  Picture picture = blank_picture(columns * width, rows * width);
  std::string lines, labels;
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const Scenario& scenario = *shown[k].scenario;
    const SmoothLine line = shown_line(shown[k], top);
    const std::array<View, 2> views = views_of(k, shown.size());
    const std::array<Camera, 2> cameras{outside(scenario.cavity), cut(scenario.cavity)};
    for (std::size_t j = 0; j < 2; ++j) {
      put(picture, wire_picture(line, scenario.wire.radius, cameras[j], width),
          views[j].column * width, views[j].row * width);
      lines += outline(scenario.cavity, cameras[j], {2.0 * views[j].column, -2.0 * views[j].row});
    }
    labels +=
        fmt::format("set label {} at {},1.06 center {}\n", k + 1,
                    shown.size() == 1 ? 1 : 2 * views[0].column, gnuplot_text(shown[k].caption));
  }
  const std::string commands =
      layout(canvas, top_margin, rows, width) + labels + gnuplot_palette() +
      fmt::format("set cbrange [0:{:.3g}]\n", top) + "$cavity << EOD\n" + lines + "EOD\n" +
      fmt::format(
          "plot 'packing.ppm' binary skip={0} array=({1},{2}) flipy format='%uchar' "
          "origin=({3:.6f},{4:.6f}) dx={5:.9f} dy={5:.9f} with rgbimage, "
          "$cavity with lines lw 0.8 lc rgb '#888888', NaN with points palette\n",
          pixmap_header(picture).size(), picture.width, picture.height, -1 + 1.0 / width,
          1 - 2 * rows + 1.0 / width, 2.0 / width);
  return {"packing", node_table(shown), commands, canvas, {{"packing.ppm", pixmap(picture)}}};
}

void draw_packing(const std::filesystem::path& folder, const std::vector<FigureRun>& runs) {
  std::vector<const FigureRun*> chosen{&runs.front()};
  for (const FigureRun& run : runs) {
    if (run.scenario.setup == chosen.front()->scenario.setup) continue;
    chosen.push_back(&run);
    break;
  }
  std::vector<ShownPacking> shown;
  double top = 0;
  for (const FigureRun* run : chosen) {
    shown.push_back({&run->scenario, &run->frame, packing_caption(run->scenario, run->frame)});
    top = std::max(top, top_of_colours(run->scenario, run->frame));
  }
  draw_with_gnuplot(folder, packing_drawing(shown, top, 760));
}

}  // namespace wirepack
