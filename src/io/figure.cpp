#include "wirepack/io/figure.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "wirepack/core/plain_text.hpp"
#include "wirepack/observe/spool_model.hpp"

#include "gnuplot.hpp"
#include "node_values.hpp"
#include "tube.hpp"

namespace wirepack {

namespace {

// Grid of a tube's surface for gnuplot: a block of lines to each point of the centreline, and one
// of no radius to close each end.
std::string tube(const SmoothLine& line, double radius) {
  constexpr Index around = 24;
  const Points rings = tube_rings(line.points, radius, around);
  std::string text = "# x y z colour\n";
  const Index n = line.points.cols();
  const auto add_ring = [&](Index k, auto&& point) {
    for (Index j = 0; j <= around; ++j) {
      const Vec3 r = point(j % around);
      text += fmt::format("{:.4f} {:.4f} {:.4f} {:.4g}\n", r.x(), r.y(), r.z(), line.colour[k]);
    }
    text += "\n";
  };
  const auto add_end = [&](Index k) {
    add_ring(k, [&](Index) -> Vec3 { return line.points.col(k); });
  };
  add_end(0);
  for (Index k = 0; k < n; ++k) {
    add_ring(k, [&](Index j) -> Vec3 { return rings.col(k * around + j); });
  }
  add_end(n - 1);
  return text;
}

}  // namespace

std::vector<std::string> figure_files(const std::vector<std::string>& names) {
  std::vector<std::string> files;
  for (const std::string& name : names) {
    for (const char* ending : {".dat", ".gp", ".png", ".pdf", ".svg"})
      files.push_back(name + ending);
  }
  return files;
}

namespace {

constexpr const char* colours =
    "set palette defined (0 '#2b5c8a', 0.35 '#6fb1c8', 0.6 '#f2e2b0', 1 '#b5342c')\n"
    "set colorbox horizontal user origin 0.2,0.1 size 0.6,0.02\nset cbtics\n"
    "set cblabel 'bending energy per length / (YI / 2R^2)'\n";

// The range of colours leaves out the few largest values.
std::string colour_range(const Eigen::VectorXd& colour) {
  return fmt::format("set cbrange [0:{:.3g}]\n", top_of_colours(colour));
}

// Ellipses in which the plane y = 0 cuts the edges: x z, both diameters, the angle of the long one,
// colour.
std::string section_ellipses(const Points& nodes, const Eigen::VectorXd& colour, double radius) {
  std::string text = "# x z long_diameter short_diameter angle colour\n";
  for (Index j = 0; j + 1 < nodes.cols(); ++j) {
    const Vec3 a = nodes.col(j), b = nodes.col(j + 1);
    if ((a.y() < 0) == (b.y() < 0)) continue;
    const Vec3 t = (b - a).normalized(), r = a - a.y() / (b.y() - a.y()) * (b - a);
    // where the wire lies in the plane, its ellipse is not longer than ten diameters
    const double steep = std::max(0.1, std::abs(t.y()));
    text += fmt::format("{:.4f} {:.4f} {:.4f} {:.4f} {:.2f} {:.4g}\n", r.x(), r.z(),
                        2 * radius / steep, 2 * radius, std::atan2(t.z(), t.x()) * 180 / pi,
                        (colour[j] + colour[j + 1]) / 2);
  }
  return text;
}

// Where the wall is seen edge-on along the line of sight of `set view 65,30`: an ellipsoid is a
// sphere of radius 1 along its axes, and turns that circle to one across the shrunk line.
std::string cavity_outline(const Cavity& cavity) {
  const double tilt = 65 * pi / 180, turn = 30 * pi / 180;
  const Vec3 right(std::cos(turn), std::sin(turn), 0);
  const Vec3 up(-std::sin(turn) * std::cos(tilt), std::cos(turn) * std::cos(tilt), std::sin(tilt));
  const Vec3 axes = semi_axes_of(cavity);
  const Vec3 sight = right.cross(up).cwiseQuotient(axes).normalized();
  const Vec3 first = sight.cross(up).normalized(), second = sight.cross(first);
  std::string text = "$cavity << EOD\n";
  for (int k = 0; k <= 120; ++k) {
    const Vec3 r =
        axes.cwiseProduct(std::cos(pi * k / 60) * first + std::sin(pi * k / 60) * second);
    text += fmt::format("{:.4f} {:.4f} {:.4f}\n", r.x(), r.y(), r.z());
  }
  return text + "EOD\n";
}

}  // namespace

void draw_packing(const std::filesystem::path& folder, const Scenario& scenario,
                  const PackingFrame& frame) {
  const Vec3 axes = semi_axes_of(scenario.cavity);
  const double radius = axes.maxCoeff();
  const Eigen::VectorXd colour = scaled_bend_energy(scenario, frame);
  const Index parts = smooth_parts(frame.rod.node_count());
  const std::string range = fmt::format("[{0}:{1}]", -1.03 * radius, 1.03 * radius);
  const std::string commands =
      "unset border\nunset tics\nunset key\nset view 65,30,1.5\nset view equal xyz\n"
      "set xrange " +
      range + "\nset yrange " + range + "\nset zrange " + range + "\n" + colour_range(colour) +
      colours + "set pm3d depthorder lighting primary 0.45 specular 0.25\n" +
      cavity_outline(scenario.cavity) +
      "splot 'packing.dat' using 1:2:3:4 with pm3d, $cavity with lines lw 0.7 lc rgb '#999999'\n";
  draw_with_gnuplot(folder, "packing",
                    tube(smooth_line(frame.rod.nodes, colour, parts), scenario.wire.radius),
                    commands, "12cm,12cm", "1200,1200");
}

void draw_section(const std::filesystem::path& folder, const Scenario& scenario,
                  const PackingFrame& frame) {
  const Vec3 axes = semi_axes_of(scenario.cavity);
  const double radius = axes.maxCoeff();
  const Eigen::VectorXd colour = scaled_bend_energy(scenario, frame);
  const std::string range = fmt::format("[{0}:{1}]", -1.03 * radius, 1.03 * radius);
  const std::string commands =
      "unset border\nunset tics\nunset key\nset size ratio -1\nset lmargin at screen 0.05\n"
      "set rmargin at screen 0.95\nset bmargin at screen 0.14\nset tmargin at screen 0.98\n"
      "set xrange " +
      range + "\nset yrange " + range + "\n" + colour_range(colour) + colours +
      fmt::format(
          "set object 1 ellipse at 0,0 size {},{} units xy fs empty border lc rgb '#999999'\n",
          2 * axes.x(), 2 * axes.z()) +
      "plot 'section.dat' using 1:2:3:4:5:6 with ellipses units xx fs solid 1 border lc rgb "
      "'#444444' "
      "fc palette\n";
  draw_with_gnuplot(folder, "section",
                    section_ellipses(frame.rod.nodes, colour, scenario.wire.radius), commands,
                    "12cm,12cm", "1200,1200");
}

void draw_fit(const std::filesystem::path& folder, const MeasuredPoints& points,
              const ShapeFit& fit) {
  std::string data = "# points: x y z arc distance\n";
  for (Index i = 0; i < points.count(); ++i) {
    const Vec3 p = points.position.col(i);
    data += fmt::format("{} {} {} {} {}\n", p.x(), p.y(), p.z(), fit.arc[i], fit.distance[i]);
  }
  data += "\n\n# fitted shape: x y z\n";
  for (Index i = 0; i < fit.curve.cols(); ++i) {
    data += fmt::format("{} {} {}\n", fit.curve(0, i), fit.curve(1, i), fit.curve(2, i));
  }
  // a fifth of the extent or so, as 1, 2 or 5 times a power of ten: tics of all axes
  const Vec3 extent = points.position.rowwise().maxCoeff() - points.position.rowwise().minCoeff();
  const double power = std::pow(10.0, std::floor(std::log10(extent.maxCoeff() / 5)));
  const double part = extent.maxCoeff() / 5 / power;
  const double step = power * (part > 5 ? 10 : part > 2 ? 5 : part > 1 ? 2 : 1);
  // thousands of points would hide the curve
  const Index every = std::max<Index>(1, points.count() / 1000);
  const std::string commands = fmt::format(
      "set multiplot\n"
      "set origin 0,0.36\nset size 1,0.62\nset view equal xyz\nset view 60,30,1.05\n"
      "set xyplane relative 0\nset border 4095 lc rgb '#bbbbbb'\nset xlabel 'x'\nset ylabel "
      "'y'\nset zlabel 'z'\n"
      "set xtics {0}\nset ytics {0}\nset ztics {0}\nset key at screen 0.95,0.97\n"
      "splot 'fit.dat' index 0 every {1} using 1:2:3 with points pt 7 ps 0.5 lc rgb '#2b5c8a' "
      "title 'points', '' index 1 using 1:2:3 with lines lw 1.5 lc rgb '#b5342c' title 'fit'\n"
      "set origin 0,0\nset size 1,0.34\nset xtics autofreq\nset ytics autofreq\nset yrange [0:*]\n"
      "set key inside top right\nset xlabel 'arc length'\nset ylabel 'distance'\n"
      "set grid lc rgb '#dddddd'\nset border 3 lc rgb 'black'\nset tics nomirror\n"
      "plot 'fit.dat' index 0 every {1} using 4:5 with points pt 7 ps 0.4 lc rgb '#2b5c8a' "
      "notitle, "
      "{2} with lines dashtype 2 lc rgb '#b5342c' title 'root mean square'\n"
      "unset multiplot\nreset\n",
      step, every, fit.residual_rms);
  draw_with_gnuplot(folder, "fit", data, commands, "14cm,17cm", "1200,1450");
}

void draw_curves(const std::filesystem::path& folder, const std::string& name,
                 const std::string& quantity, const std::vector<Curve>& curves) {
  std::string data, commands;
  std::vector<double> values;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const Curve& curve = curves[k];
    data += fmt::format("# {}\n# packing_density {}\n", plain_text(curve.label), quantity);
    for (const auto& [x, y] : curve.points) {
      data += fmt::format("{} {}\n", x, y);
      if (curve.stroke != Stroke::dashed_line) values.push_back(y);
    }
    if (curve.points.empty()) data += "NaN NaN\n";
    data += "\n\n";
    const char* style = curve.stroke == Stroke::marks         ? "points pt 7 ps 1"
                        : curve.stroke == Stroke::dashed_line ? "lines lw 1.5 dashtype 2"
                                                              : "lines lw 1";
    const std::string colour = curve.colour == 0 ? "rgb 'black'" : fmt::format("{}", curve.colour);
    commands +=
        fmt::format("{} '{}.dat' index {} with {} lc {} {}", commands.empty() ? "plot" : ",", name,
                    k, style, colour, curve.label.empty() ? "notitle" : gnuplot_title(curve.label));
  }
  // The range leaves out the highest peaks of the force.
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const auto last = static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(std::round(share * last))];
  };
  std::string range;
  if (!values.empty()) {
    const double top = at(0.99), bottom = std::min(0.0, at(0.01));
    range = fmt::format("set yrange [{:.4g}:{:.4g}]\n", 1.1 * bottom, std::max(1e-3, 1.35 * top));
  }
  draw_with_gnuplot(folder, name, data,
                    std::string(curve_style) + "set ylabel '" + quantity + "' noenhanced\n" +
                        range + commands + "\n",
                    "14cm,10cm", "1200,860");
}

}  // namespace wirepack
