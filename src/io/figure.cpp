#include "wirepack/io/figure.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "wirepack/core/error.hpp"
#include "wirepack/core/plain_text.hpp"
#include "wirepack/io/output_path.hpp"
#include "wirepack/observe/spool_model.hpp"

#include "atomic_file.hpp"
#include "node_values.hpp"
#include "tube.hpp"

namespace wirepack {

namespace {

void write_file(const std::filesystem::path& path, const std::string& text) {
  replace_file(path, std::vector<char>(text.begin(), text.end()));
}

/// A folder beside the figures for gnuplot to draw in, so that no figure is ever half a one.
class DrawingFolder {
 public:
  explicit DrawingFolder(const std::filesystem::path& beside) {
    std::string name = (beside / ".figure.XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw FileError(beside.string() + ": cannot be written: " + std::strerror(errno));
    }
    path_ = name;
  }
  ~DrawingFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  DrawingFolder(const DrawingFolder&) = delete;
  DrawingFolder& operator=(const DrawingFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Runs gnuplot on NAME.gp inside the folder, without a shell. The script is kept at `script`.
void run_gnuplot(const std::filesystem::path& folder, const std::string& name,
                 const std::filesystem::path& script) {
  std::array<std::string, 2> words{"gnuplot", name + ".gp"};
  std::array<char*, 3> arguments{words[0].data(), words[1].data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) {
    throw FileError("gnuplot cannot be started: install it, or draw " + script.string() +
                    " elsewhere");
  }
  int status = 0;
  if (waitpid(child, &status, 0) != child || status != 0) {
    throw FileError("gnuplot failed on " + script.string());
  }
}

// A title that gnuplot shows to the letter.
std::string title(const std::string& text) {
  std::string quoted;
  for (const char c : plain_text(text)) quoted += c == '\'' ? "\'\'" : std::string(1, c);
  return "title '" + quoted + "' noenhanced";
}

void draw(const std::filesystem::path& folder, const std::string& name, const std::string& data,
          const std::string& commands, const std::string& size, const std::string& pixels) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(folder.string() + ": cannot be made: " + error.message());
  std::string script = fmt::format("# draws {0}.png, {0}.pdf and {0}.svg from {0}.dat\n", name);
  const auto add = [&](const std::string& terminal, const std::string& extension) {
    script += fmt::format("set terminal {}\nset output '{}.{}'\n", terminal, name, extension);
    script += commands + "unset output\n";
  };
  add("pngcairo size " + pixels + " font 'sans,20' linewidth 2", "png");
  add("pdfcairo size " + size + " font 'sans,12'", "pdf");
  add("svg size 800,800 font 'sans,16'", "svg");
  const DrawingFolder drawing(folder);
  write_file(drawing.path() / (name + ".dat"), data);
  write_file(drawing.path() / (name + ".gp"), script);
  const auto keep = [&](const std::string& file) {
    const std::filesystem::path target = output_file(folder / file, {.inputs = {}, .force = true});
    replace_file(target, read_bytes(drawing.path() / file));
  };
  // data and script first: without gnuplot they are what is left
  for (const char* ending : {".dat", ".gp"}) keep(name + ending);
  run_gnuplot(drawing.path(), name, folder / (name + ".gp"));
  for (const char* ending : {".png", ".pdf", ".svg"}) keep(name + ending);
}

// Grid of a tube's surface for gnuplot: a block of lines to each point of the centreline, and one of no
// radius to close each end.
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

SpoolModel spool_of(const Scenario& scenario) {
  return {scenario.cavity, scenario.wire.radius, stiffness(scenario.wire).bend,
          SpoolModel::seen_spacing * scenario.wire.radius};
}

// Blocks for gnuplot's `index`: one to each run, then the model of each run.
std::string curves(const std::vector<FigureRun>& runs) {
  std::string text;
  for (const FigureRun& run : runs) {
    const double unit = units_of(run.scenario).scaled_energy();
    text += fmt::format("# {}\n# packing_density F*R^2/YI E_bend*R/YI E_twist*R/YI\n",
                        plain_text(run.label));
    for (const HistoryRow& row : run.history) {
      text += fmt::format("{} {} {} {}\n", row.packing_density, row.scaled_force,
                          row.energy_bend / unit, row.energy_twist / unit);
    }
    text += "\n\n";
  }
  for (const FigureRun& run : runs) {
    const SpoolModel spool = spool_of(run.scenario);
    const Units units = units_of(run.scenario);
    const double last = run.history.empty() ? 0 : run.history.back().packing_density;
    text += fmt::format("# inverse spool beside {}\n# packing_density F*R^2/YI E_bend*R/YI\n",
                        run.label);
    for (int k = 0; k <= 100; ++k) {
      const double phi = std::min(last, 0.99 * spool.largest_density()) * k / 100;
      text += fmt::format("{} {} {}\n", phi, spool.injection_force(phi) / units.scaled_force(),
                          spool.bend_energy(phi) / units.scaled_energy());
    }
    text += "\n\n";
  }
  return text;
}

// One plot command: every run in column `column`, then the model of each.
std::string plot(const std::vector<FigureRun>& runs, const std::string& name, int column,
                 const std::string& quantity) {
  std::string text;
  const auto line = [&](std::size_t index, std::size_t colour, int dash, const std::string& what) {
    text +=
        fmt::format("{} '{}.dat' index {} using 1:{} with lines lw 1.5 dashtype {} lc {} {}",
                    text.empty() ? "plot" : ",", name, index, column, dash, colour, title(what));
  };
  for (std::size_t k = 0; k < runs.size(); ++k) line(k, k + 1, 1, quantity + runs[k].label);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    line(runs.size() + k, k + 1, 2, "inverse spool (d = 2.81 a) for " + runs[k].label);
  }
  return text;
}

// From 0 to a little above the largest value of the runs; the model may leave the picture.
template <class Value>
std::string height(const std::vector<FigureRun>& runs, Value&& value) {
  double top = 1e-3;
  for (const FigureRun& run : runs) {
    for (const HistoryRow& row : run.history) top = std::max(top, value(run.scenario, row));
  }
  return fmt::format("set yrange [0:{:.3g}]\n", 1.35 * top);
}

constexpr const char* curve_style =
    "set xlabel 'packing density {/Symbol f}'\nset key below Left reverse maxcols 1\nset grid lc "
    "rgb "
    "'#dddddd'\nset border 3\nset tics nomirror\n";

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

// Ellipses in which the plane y = 0 cuts the edges: x z, both diameters, the angle of the long one, colour.
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

// The great circle across the line of sight of `set view 65,30`.
std::string cavity_outline(double radius) {
  const double tilt = 65 * pi / 180, turn = 30 * pi / 180;
  const Vec3 right(std::cos(turn), std::sin(turn), 0);
  const Vec3 up(-std::sin(turn) * std::cos(tilt), std::cos(turn) * std::cos(tilt), std::sin(tilt));
  std::string text = "$cavity << EOD\n";
  for (int k = 0; k <= 120; ++k) {
    const Vec3 r = radius * (std::cos(pi * k / 60) * right + std::sin(pi * k / 60) * up);
    text += fmt::format("{:.4f} {:.4f} {:.4f}\n", r.x(), r.y(), r.z());
  }
  return text + "EOD\n";
}

}  // namespace

void draw_packing(const std::filesystem::path& folder, const Scenario& scenario,
                  const PackingFrame& frame) {
  const double radius = scenario.cavity.radius;
  const Eigen::VectorXd colour = scaled_bend_energy(scenario, frame);
  const Index parts = smooth_parts(frame.rod.node_count());
  const std::string range = fmt::format("[{0}:{1}]", -1.03 * radius, 1.03 * radius);
  const std::string commands =
      "unset border\nunset tics\nunset key\nset view 65,30,1.5\nset view equal xyz\n"
      "set xrange " +
      range + "\nset yrange " + range + "\nset zrange " + range + "\n" + colour_range(colour) +
      colours + "set pm3d depthorder lighting primary 0.45 specular 0.25\n" +
      cavity_outline(radius) +
      "splot 'packing.dat' using 1:2:3:4 with pm3d, $cavity with lines lw 0.7 lc rgb '#999999'\n";
  draw(folder, "packing", tube(smooth_line(frame.rod.nodes, colour, parts), scenario.wire.radius),
       commands, "12cm,12cm", "1200,1200");
}

void draw_section(const std::filesystem::path& folder, const Scenario& scenario,
                  const PackingFrame& frame) {
  const double radius = scenario.cavity.radius;
  const Eigen::VectorXd colour = scaled_bend_energy(scenario, frame);
  const std::string range = fmt::format("[{0}:{1}]", -1.03 * radius, 1.03 * radius);
  const std::string commands =
      "unset border\nunset tics\nunset key\nset size ratio -1\nset lmargin at screen 0.05\n"
      "set rmargin at screen 0.95\nset bmargin at screen 0.14\nset tmargin at screen 0.98\n"
      "set xrange " +
      range + "\nset yrange " + range + "\n" + colour_range(colour) + colours +
      fmt::format("set object 1 circle at 0,0 size {} fs empty border lc rgb '#999999'\n", radius) +
      "plot 'section.dat' using 1:2:3:4:5:6 with ellipses units xx fs solid 1 border lc rgb "
      "'#444444' "
      "fc palette\n";
  draw(folder, "section", section_ellipses(frame.rod.nodes, colour, scenario.wire.radius), commands,
       "12cm,12cm", "1200,1200");
}

void draw_force(const std::filesystem::path& folder, const std::vector<FigureRun>& runs) {
  // The peak before the first contact is many times what follows: a log axis shows both.
  double top = 1;
  for (const FigureRun& run : runs) {
    for (const HistoryRow& row : run.history) top = std::max(top, row.scaled_force);
  }
  draw(folder, "force", curves(runs),
       curve_style +
           fmt::format("set ylabel 'injection force F R^2 / YI'\nset logscale y\n"
                       "set yrange [0.1:{:.3g}]\n",
                       1.5 * top) +
           plot(runs, "force", 2, "") + "\n",
       "14cm,12cm", "1200,1030");
}

void draw_energy(const std::filesystem::path& folder, const std::vector<FigureRun>& runs) {
  std::string twist;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    twist += fmt::format(", 'energy.dat' index {} using 1:4 with lines lw 1.5 dashtype 3 lc {} {}",
                         k, k + 1, title("twist, " + runs[k].label));
  }
  draw(folder, "energy", curves(runs),
       curve_style + std::string("set ylabel 'energy E R / YI'\n") +
           height(runs,
                  [](const Scenario& scenario, const HistoryRow& row) {
                    return row.energy_bend / units_of(scenario).scaled_energy();
                  }) +
           plot(runs, "energy", 3, "bending, ") + twist + "\n",
       "14cm,12cm", "1200,1030");
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
  draw(folder, "fit", data, commands, "14cm,17cm", "1200,1450");
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
                    k, style, colour, curve.label.empty() ? "notitle" : title(curve.label));
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
  draw(folder, name, data,
       curve_style + std::string("set ylabel '") + quantity + "' noenhanced\n" + range + commands +
           "\n",
       "14cm,10cm", "1200,860");
}

}  // namespace wirepack
