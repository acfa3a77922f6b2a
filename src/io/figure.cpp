#include "wirepack/io/figure.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "wirepack/core/plain_text.hpp"

#include "curve_layout.hpp"
#include "gnuplot.hpp"

namespace wirepack {

std::vector<std::string> figure_files(const std::vector<std::string>& names) {
  std::vector<std::string> files;
  for (const std::string& name : names) {
    for (const char* ending : {".dat", ".gp", ".png", ".pdf", ".svg"})
      files.push_back(name + ending);
    if (name == "packing") files.emplace_back("packing.ppm");
  }
  return files;
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
  // the same tics on all axes
  const Vec3 extent = points.position.rowwise().maxCoeff() - points.position.rowwise().minCoeff();
  const double step = tic_step(extent.maxCoeff(), 5);
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
  draw_with_gnuplot(folder, {"fit", data, commands, {1200, 1450}, {}});
}

void draw_curves(const std::filesystem::path& folder, const std::string& name,
                 const std::string& quantity, const std::vector<Curve>& curves) {
  std::string data, commands;
  std::vector<double> values;
  double last = 0;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const Curve& curve = curves[k];
    data += fmt::format("# {}\n# packing_density {}\n", plain_text(curve.label), quantity);
    for (const auto& [x, y] : curve.points) {
      data += fmt::format("{} {}\n", x, y);
      last = std::max(last, x);
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
    const auto highest = static_cast<double>(values.size() - 1);
    return values[static_cast<std::size_t>(std::round(share * highest))];
  };
  std::string range = fmt::format("set xrange [0:{:.4g}]\n", last > 0 ? last : 1);
  if (!values.empty()) {
    const double top = at(0.99), bottom = std::min(0.0, at(0.01));
    range += fmt::format("set yrange [{:.4g}:{:.4g}]\n", 1.1 * bottom, std::max(1e-3, 1.35 * top));
  }
  const CurveLayout layout(static_cast<std::size_t>(std::count_if(
      curves.begin(), curves.end(), [](const Curve& curve) { return !curve.label.empty(); })));
  draw_with_gnuplot(folder, {name,
                             data,
                             layout.graph() + density_axis + "set ylabel '" + quantity +
                                 "' noenhanced\n" + range + commands + "\n",
                             layout.canvas(),
                             {}});
}

}  // namespace wirepack
