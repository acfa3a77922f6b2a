#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>

#include "wirepack/core/plain_text.hpp"
#include "wirepack/io/figure.hpp"
#include "wirepack/io/scenario_groups.hpp"
#include "wirepack/observe/power_law.hpp"
#include "wirepack/observe/sample.hpp"
#include "wirepack/packing/mean_force.hpp"

#include "curve_layout.hpp"
#include "gnuplot.hpp"
#include "published.hpp"
#include "setup_name.hpp"

namespace wirepack {

namespace {

// Runs that differ in their seeds alone.
struct Reading {
  double ratio;  // a / R
  std::vector<double> densities;
};

// Readings that one law is fitted to.
struct ReadingSeries {
  std::string name;
  std::vector<Reading> readings;
};

// A run and its density at the threshold.
struct RunReading {
  const FigureRun* run;
  double density;
};

std::vector<Scenario> scenarios_of(const std::vector<RunReading>& runs) {
  std::vector<Scenario> scenarios;
  for (const RunReading& reading : runs) scenarios.push_back(reading.run->scenario);
  return scenarios;
}

// Of the runs that have one: others tell nothing here, and should split no series.
std::vector<RunReading> readings_of(const std::vector<FigureRun>& runs,
                                    const PhiMaxThreshold& threshold) {
  std::vector<RunReading> readings;
  for (const FigureRun& run : runs) {
    const double fed = threshold.fed_over_radius * run.scenario.cavity.radius;
    const double force = threshold.scaled_force * units_of(run.scenario).scaled_force();
    const auto density = density_at_force(mean_forces(run.scenario, run.history, fed), force);
    if (density) readings.push_back({&run, *density});
  }
  return readings;
}

std::vector<Reading> by_seeds(const std::vector<RunReading>& series) {
  std::vector<Reading> readings;
  for (const auto& group : seed_groups(scenarios_of(series))) {
    const Scenario& scenario = series[group.front()].run->scenario;
    Reading reading{scenario.wire.radius / scenario.cavity.radius, {}};
    for (const std::size_t member : group) reading.densities.push_back(series[member].density);
    readings.push_back(reading);
  }
  return readings;
}

// Series of one setup are told apart by their first runs.
std::vector<ReadingSeries> all_series(const std::vector<RunReading>& runs) {
  const ScenarioGroups groups = radius_series(scenarios_of(runs));
  std::map<Setup, int> uses;
  for (const auto& group : groups) ++uses[runs[group.front()].run->scenario.setup];
  std::vector<ReadingSeries> series;
  for (const auto& group : groups) {
    const FigureRun& first = *runs[group.front()].run;
    std::string name = setup_name(first.scenario.setup);
    if (uses[first.scenario.setup] > 1) name += fmt::format(", as {}", first.label);
    std::vector<RunReading> members;
    for (const std::size_t k : group) members.push_back(runs[k]);
    series.push_back({name, by_seeds(members)});
  }
  return series;
}

// The mass is that of the wire over that of a ball of its radius: phi_max (R/a)^3.
std::string block(const ReadingSeries& series) {
  std::string text = fmt::format("# {}\n# a/R phi_max standard_error runs R/a mass its_error\n",
                                 plain_text(series.name));
  for (const Reading& reading : series.readings) {
    const Sample s = sample(reading.densities);
    const double error = s.count > 1 ? s.standard_error() : 0, balls = std::pow(reading.ratio, -3);
    text += fmt::format("{} {} {} {} {} {} {}\n", reading.ratio, s.mean, error, s.count,
                        1 / reading.ratio, s.mean * balls, error * balls);
  }
  return text + "\n\n";
}

// Where the axis begins: below every point. Under the points there is room for an inset.
double lowest_axis_density(const std::vector<ReadingSeries>& series, bool with_inset) {
  double lowest = 0.15;
  for (const ReadingSeries& one : series) {
    for (const Reading& reading : one.readings) {
      lowest =
          std::min(lowest, *std::min_element(reading.densities.begin(), reading.densities.end()));
    }
  }
  return lowest * (with_inset ? 0.2 : 0.67);
}

// The fitted law as one more curve; nothing where there are too few readings to fit one.
std::string fitted_law(const ReadingSeries& series, std::size_t colour) {
  std::vector<double> x, y;
  for (const Reading& reading : series.readings) {
    x.insert(x.end(), reading.densities.size(), reading.ratio);
    y.insert(y.end(), reading.densities.begin(), reading.densities.end());
  }
  if (x.size() < 3 || std::set<double>(x.begin(), x.end()).size() < 2) return "";
  const PowerLaw law = fit_power_law(x, y);
  return fmt::format(
      ", {} * x**{} with lines lw 1.5 lc {} {}", law.factor, law.exponent, colour,
      gnuplot_title(fmt::format("{}: exponent {:.2f} +- {:.2f}, {} runs", series.name, law.exponent,
                                law.exponent_error, x.size())));
}

constexpr const char* axes =
    "set logscale xy\nset xrange [0.015:0.4]\n"
    "set xtics (0.02, 0.05, 0.1, 0.2)\nset ytics (0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1)\n"
    "set object 1 rectangle from graph 0, first coils_lowest to graph 1, first coils_highest "
    "behind fs solid 0.5 noborder fc rgb '#e8e8e8'\n"
    "set label 1 'endovascular coils, clinical' at graph 0.98, first 0.215 right tc rgb "
    "'#777777'\n";

constexpr const char* published_curves =
    "paper_phi_max(x) with lines dashtype 2 lc rgb 'black' title sprintf('Stoop et al. 2011, "
    "high torsion: exponent %.2f', paper_exponent), "
    "$phages using 1:2 with points pt 4 ps 1 lc rgb '#555555' title 'DNA in phages'";

std::string mass_inset(const CurveLayout& layout, std::size_t series) {
  std::string text = layout.inset({0.4, 0.99, 0.01, 0.47}) +
                     "unset object 1\nunset label 1\nset xrange [2.5:60]\nset yrange [5:1e5]\n"
                     "set xtics (5, 10, 20, 50)\nset ytics autofreq\nset format y '10^{%T}'\n"
                     "set xlabel 'R / a'\nset ylabel 'mass φ (R/a)^3'\n"
                     "set label 2 sprintf('Stoop et al. 2011: %.2f', paper_mass_exponent) at graph "
                     "0.98, 0.26 right "
                     "font small\n"
                     "set label 3 sprintf('Aguiar et al. 1991: %.2f', aguiar_mass_exponent) at "
                     "graph 0.98, 0.1 right "
                     "font small tc rgb '#888888'\nplot ";
  for (std::size_t k = 0; k < series; ++k) {
    text += fmt::format(
        "'phi_max.dat' index {} using 5:6:7 with yerrorbars pt 7 ps 0.8 "
        "lc {}, ",
        k, k + 1);
  }
  return text +
         "paper_phi_max(1/x) * x**3 with lines dashtype 2 lc rgb 'black', "
         "paper_phi_max(0.25) * 64 * (x / 4)**aguiar_mass_exponent with lines dashtype 3 "
         "lc rgb '#888888'\n";
}

std::string density_label(const PhiMaxThreshold& threshold) {
  const std::string label =
      fmt::format("packing density at F R^2 / YI = {}", threshold.scaled_force);
  if (threshold.fed_over_radius == 0) return label;
  return label + fmt::format(", mean over {} R", threshold.fed_over_radius);
}

bool has_two_radii(const std::vector<ReadingSeries>& series) {
  return std::any_of(series.begin(), series.end(),
                     [](const ReadingSeries& s) { return s.readings.size() > 1; });
}

}  // namespace

PhiMaxFigure draw_phi_max(const std::filesystem::path& folder, const std::vector<FigureRun>& runs,
                          const PhiMaxThreshold& threshold) {
  const std::vector<ReadingSeries> series = all_series(readings_of(runs, threshold));
  if (series.empty()) return PhiMaxFigure::none;
  std::string data, points, laws;
  std::size_t key_lines = series.size() + 2;
  for (std::size_t k = 0; k < series.size(); ++k) {
    data += block(series[k]);
    points += fmt::format(
        "'phi_max.dat' index {} using 1:2:3 with yerrorbars pt 7 ps 1 lw 1.5 lc {} {}, ", k, k + 1,
        gnuplot_title(series[k].name));
    const std::string law = fitted_law(series[k], k + 1);
    if (!law.empty()) ++key_lines;
    laws += law;
  }
  const CurveLayout layout(key_lines);
  const bool whole = has_two_radii(series);
  const std::string commands =
      std::string(published_numbers) + "set multiplot\n" + layout.graph() +
      fmt::format("set xlabel 'a / R'\nset ylabel '{}'\n", density_label(threshold)) + axes +
      fmt::format("set yrange [{:.3g}:1]\n", lowest_axis_density(series, whole)) + "plot " +
      points + published_curves + laws + "\n" + (whole ? mass_inset(layout, series.size()) : "") +
      "unset multiplot\nreset\n";
  draw_with_gnuplot(folder, {"phi_max", data, commands, layout.canvas(), {}});
  return whole ? PhiMaxFigure::whole : PhiMaxFigure::without_inset;
}

}  // namespace wirepack
