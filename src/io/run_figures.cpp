#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "wirepack/core/plain_text.hpp"
#include "wirepack/io/figure.hpp"
#include "wirepack/observe/log_normal.hpp"
#include "wirepack/observe/spool_model.hpp"

#include "curve_layout.hpp"
#include "gnuplot.hpp"
#include "published.hpp"
#include "run_groups.hpp"

namespace wirepack {

namespace {

// Columns of the curves of a group, each followed by its standard error.
enum Column { force_column = 2, bend_column = 4, twist_column = 6 };

SpoolModel spool_of(const Scenario& scenario) {
  return {scenario.cavity, scenario.wire.radius, stiffness(scenario.wire).bend,
          SpoolModel::seen_spacing * scenario.wire.radius};
}

// The model, to the last density of the group, in the same columns.
std::string spool_curve(const RunGroup& group) {
  const Scenario& scenario = group.runs.front()->scenario;
  const SpoolModel spool = spool_of(scenario);
  const Units units = units_of(scenario);
  const double last = group.points.empty() ? 0 : group.points.back().packing_density;
  std::string text = fmt::format("# inverse spool beside {}\n", plain_text(group.label));
  for (int k = 0; k <= 100; ++k) {
    const double phi = std::min(last, 0.99 * spool.largest_density()) * k / 100;
    text += fmt::format("{} {} 0 {} 0\n", phi, spool.injection_force(phi) / units.scaled_force(),
                        spool.bend_energy(phi) / units.scaled_energy());
  }
  return text + "\n\n";
}

// Blocks for gnuplot's `index`: one to each group, then the model of each.
std::string curves(const std::vector<RunGroup>& groups) {
  std::string text;
  for (const RunGroup& group : groups) {
    text += fmt::format(
        "# {}\n# packing_density F*R^2/YI its_error E_bend*R/YI its_error E_twist*R/YI its_error\n",
        plain_text(group.label));
    const auto value = [](const Sample& s) {
      return fmt::format("{} {}", s.mean, s.count > 1 ? s.standard_error() : 0);
    };
    for (const CurvePoint& p : group.points) {
      text += fmt::format("{} {} {} {}\n", p.packing_density, value(p.force), value(p.bend),
                          value(p.twist));
    }
    text += group.points.empty() ? "NaN NaN 0 NaN 0 NaN 0\n\n\n" : "\n\n";
  }
  for (const RunGroup& group : groups) text += spool_curve(group);
  return text;
}

// Plots every group's column, with its band of errors.
std::string plot_curves(const std::vector<RunGroup>& groups, const std::string& figure,
                        int column) {
  std::string text;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const std::string data = fmt::format("'{}.dat' index {}", figure, k);
    if (groups[k].runs.size() > 1) {
      text += fmt::format(
          "{0} using 1:(${1}-${2}):(${1}+${2}) with filledcurves lc {3} fs transparent solid 0.25 "
          "noborder notitle, ",
          data, column, column + 1, k + 1);
    }
    text += fmt::format("{} using 1:{} with lines lw 1.5 lc {} {}, ", data, column, k + 1,
                        gnuplot_title(groups[k].label));
  }
  return text;
}

constexpr const char* spool_name = "dashed: inverse spool, d = 2.81 a";

// To a packing density.
double largest(const std::vector<RunGroup>& groups, Sample CurvePoint::*quantity, double end = 1) {
  double top = 0;
  for (const RunGroup& group : groups) {
    for (const CurvePoint& point : group.points) {
      if (point.packing_density <= end) top = std::max(top, (point.*quantity).mean);
    }
  }
  return top;
}

double last_density(const std::vector<RunGroup>& groups) {
  double last = 0;
  for (const RunGroup& group : groups) {
    if (!group.points.empty()) last = std::max(last, group.points.back().packing_density);
  }
  return last > 0 ? last : 1;
}

std::string density_range(const std::vector<RunGroup>& groups) {
  return fmt::format("set xrange [0:{:.4g}]\n", last_density(groups));
}

// Torsional energies over the bending energy below which a log axis would show round-off.
constexpr double no_torsion = 1e-9;

// More than the rounding of a wire that is free to turn.
bool has_torsion(const std::vector<RunGroup>& groups) {
  const double bending = std::max(1e-3, largest(groups, &CurvePoint::bend));
  return largest(groups, &CurvePoint::twist) > no_torsion * bending;
}

std::string torsion_curves(const std::vector<RunGroup>& groups, const std::string& figure) {
  const double top = std::max(1e-9, largest(groups, &CurvePoint::twist));
  return fmt::format(
             "set ylabel 'torsional energy E R / YI'\nset logscale y\nset format y '10^{{%T}}'\n"
             "set yrange [{:.3g}:{:.3g}]\nplot ",
             1e-4 * top, 2 * top) +
         plot_curves(groups, figure, twist_column) + "NaN notitle\n";
}

constexpr double bin = 0.25, lowest_log = -9, highest_log = 4;

std::vector<double> energies_over_mean(const RunGroup& group) {
  std::vector<double> ratios;
  for (const FigureRun* run : group.runs) {
    const Eigen::VectorXd& energy = run->frame.bend_energy;
    const std::vector<double> of_run =
        over_mean({energy.data(), static_cast<std::size_t>(energy.size())});
    ratios.insert(ratios.end(), of_run.begin(), of_run.end());
  }
  return ratios;
}

// Share of the joints per unit of ln x, x = E / <E>, in bins of it.
std::string histogram(const std::vector<double>& ratios) {
  std::vector<int> counts(static_cast<std::size_t>((highest_log - lowest_log) / bin));
  for (const double x : ratios) {
    const double at = std::floor((std::log(x) - lowest_log) / bin);
    if (at >= 0 && at < static_cast<double>(counts.size())) ++counts[static_cast<std::size_t>(at)];
  }
  std::string text;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    text += fmt::format("{} {}\n", std::exp(lowest_log + (static_cast<double>(k) + 0.5) * bin),
                        counts[k] / (static_cast<double>(ratios.size()) * bin));
  }
  return text + "\n\n";
}

// All but the lowest half per cent are above.
double decade_of_the_lowest(std::vector<double> ratios) {
  const auto low = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 200);
  std::nth_element(ratios.begin(), low, ratios.end());
  return std::pow(10, std::floor(std::log10(std::max(*low, std::exp(lowest_log)))));
}

}  // namespace

void draw_force(const std::filesystem::path& folder, const std::vector<FigureRun>& runs) {
  const std::vector<RunGroup> groups = run_groups(runs);
  // The peak before the first contact is many times what follows: a log axis shows both.
  const double top = std::max(1.0, largest(groups, &CurvePoint::force));
  // scaled, the model's force is the same for all radii: the curve that goes furthest is drawn
  std::size_t furthest = 0;
  const auto end = [&](std::size_t k) {
    return groups[k].points.empty() ? 0 : groups[k].points.back().packing_density;
  };
  for (std::size_t k = 1; k < groups.size(); ++k) {
    if (end(k) > end(furthest)) furthest = k;
  }
  const CurveLayout layout(groups.size() + 1);
  draw_with_gnuplot(
      folder,
      {"force",
       curves(groups),
       layout.graph() + density_axis + density_range(groups) +
           fmt::format("set ylabel 'injection force F R^2 / YI'\nset logscale y\n"
                       "set yrange [0.1:{:.3g}]\nplot ",
                       1.5 * top) +
           plot_curves(groups, "force", force_column) +
           fmt::format(
               "'force.dat' index {} using 1:{} with lines lw 1.5 dashtype 2 lc rgb 'black' {}\n",
               groups.size() + furthest, int(force_column), gnuplot_title(spool_name)),
       layout.canvas(),
       {}});
}

void draw_energy(const std::filesystem::path& folder, const std::vector<FigureRun>& runs) {
  const std::vector<RunGroup> groups = run_groups(runs);
  const double top = std::max(1e-3, largest(groups, &CurvePoint::bend));
  std::string spools;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    spools += fmt::format(
        "'energy.dat' index {} using 1:{} with lines lw 1.5 dashtype 2 lc {} {}{}",
        groups.size() + k, int(bend_column), k + 1, k == 0 ? gnuplot_title(spool_name) : "notitle",
        k + 1 < groups.size() ? ", " : "\n");
  }
  const CurveLayout layout(groups.size() + 1);
  const CurveLayout::Box box{0.02, 0.46, 0.5, 1};
  const bool twisted = has_torsion(groups);
  // below the inset there is room for the curves
  const double beside = largest(groups, &CurvePoint::bend, box.right * last_density(groups));
  const double range = std::max(1.35 * top, twisted ? beside / (0.95 * box.bottom) : 0);
  const std::string torsion =
      twisted
          ? layout.inset(box) + fmt::format("set xtics {}\n", tic_step(last_density(groups), 4)) +
                torsion_curves(groups, "energy")
          : "";
  draw_with_gnuplot(
      folder, {"energy",
               curves(groups),
               "set multiplot\n" + layout.graph() + density_axis + density_range(groups) +
                   fmt::format("set ylabel 'bending energy E R / YI'\nset yrange [0:{:.3g}]\nplot ",
                               range) +
                   plot_curves(groups, "energy", bend_column) + spools + torsion +
                   "unset multiplot\nreset\n",
               layout.canvas(),
               {}});
}

bool draw_torsion(const std::filesystem::path& folder, const std::vector<FigureRun>& runs) {
  const std::vector<RunGroup> groups = run_groups(runs);
  if (!has_torsion(groups)) return false;
  const CurveLayout layout(groups.size());
  draw_with_gnuplot(folder, {"torsion",
                             curves(groups),
                             layout.graph() + density_axis + density_range(groups) +
                                 torsion_curves(groups, "torsion"),
                             layout.canvas(),
                             {}});
  return true;
}

void draw_bend_distribution(const std::filesystem::path& folder,
                            const std::vector<FigureRun>& runs) {
  std::string data, plots;
  std::size_t block = 0;
  double lowest_shown = 0.01;  // the published law is next to nothing below
  for (const RunGroup& group : run_groups(runs)) {
    const std::vector<double> ratios = energies_over_mean(group);
    if (ratios.size() < 2) continue;
    const LogNormalFit fit = fit_log_normal(ratios);
    data += fmt::format("# {} at a density of {:.3g}\n# x=E/<E> share_per_unit_of_ln_x\n",
                        plain_text(group.label), group.runs.front()->frame.packing_density);
    data += histogram(ratios);
    lowest_shown = std::min(lowest_shown, decade_of_the_lowest(ratios));
    plots += fmt::format(
        "'bend_distribution.dat' index {} with histeps lw 1.5 lc {} {}, "
        "exp(-((log(x) - {:.6g}) / {:.6g})**2 / 2) / (sqrt(2 * pi) * {:.6g}) with lines lw 1.5 lc "
        "{} title 'log-normal: μ = {:.2f}, σ = {:.2f}', ",
        block, block + 1, gnuplot_title(group.label), fit.mu, fit.sigma, fit.sigma, block + 1,
        fit.mu, fit.sigma);
    ++block;
  }
  const CurveLayout layout(2 * block + 1);
  const std::string commands =
      std::string(published_numbers) + layout.graph() +
      fmt::format(
          "set xlabel 'bending energy of a joint over the mean, x'\n"
          "set ylabel 'share of the joints per unit of ln x'\nset logscale x\n"
          "set xrange [{:.3g}:30]\nset yrange [0:*]\nset format x '10^{{%T}}'\n"
          "set samples 400\nplot ",
          lowest_shown) +
      plots +
      "paper_bend_distribution(x) with lines dashtype 2 lc rgb 'black' title 'Stoop et al. 2011: "
      "high torsion, a/R = 1/40'\n";
  draw_with_gnuplot(folder, {"bend_distribution", data, commands, layout.canvas(), {}});
}

}  // namespace wirepack
