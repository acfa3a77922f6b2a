#include "wirepack/fit/shape_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <tuple>

#include "wirepack/core/error.hpp"

#include "block_means.hpp"
#include "curve_problem.hpp"
#include "fit_uncertainty.hpp"
#include "helix_starts.hpp"
#include "point_order.hpp"
#include "shape_numbers.hpp"
#include "spline_start.hpp"

namespace wirepack {

namespace {

constexpr Index most_trial_points = 200;  // on which starts compete
constexpr Index most_intervals = 96;

/// Points about their middle, in units of their extent: then all unknowns are of order 1.
struct Scaled {
  MeasuredPoints points;
  Vec3 centre;
  double unit;
};

Scaled scaled(const MeasuredPoints& points) {
  Scaled result{points, points.position.rowwise().mean(), 0};
  result.unit =
      (points.position.rowwise().maxCoeff() - points.position.rowwise().minCoeff()).norm();
  result.points.position = (points.position.colwise() - result.centre) / result.unit;
  if (points.arc.size() > 0) {
    result.points.arc = (points.arc.array() - points.arc.minCoeff()) / result.unit;
  }
  if (points.sigma.size() > 0) result.points.sigma = points.sigma / result.unit;
  return result;
}

MeasuredPoints chosen(const MeasuredPoints& points, const std::vector<Index>& which) {
  MeasuredPoints result;
  result.ordered = points.ordered;
  result.position = points.position(Eigen::all, which);
  if (points.arc.size() > 0) result.arc = points.arc(which);
  if (points.sigma.size() > 0) result.sigma = points.sigma(which);
  return result;
}

// So many of the points at most, equally spaced in their list.
std::vector<Index> sample(Index count, Index most) {
  std::vector<Index> which;
  const Index used = std::min(count, most);
  for (Index i = 0; i < used; ++i) which.push_back(i * count / used);
  return which;
}

void check_points(const MeasuredPoints& points, const FitOptions& options) {
  const Index n = points.count();
  const Index least = options.model == ShapeModel::spline ? 8 : 4;
  const char* model = options.model == ShapeModel::circle  ? "circle"
                      : options.model == ShapeModel::helix ? "helix"
                                                           : "spline";
  std::set<std::tuple<double, double, double>> distinct;
  for (Index i = 0; i < n; ++i) {
    distinct.insert({points.position(0, i), points.position(1, i), points.position(2, i)});
  }
  const auto different = static_cast<Index>(distinct.size());
  if (different < least) {
    throw InvalidInput(std::to_string(n) + " points, " + std::to_string(different) +
                       " of them different: a " + model + " with its errors needs at least " +
                       std::to_string(least));
  }
  if (points.arc.size() > 0) {
    Index first = 0, last = 0;
    const double span = points.arc.maxCoeff(&last) - points.arc.minCoeff(&first);
    const double apart = (points.position.col(last) - points.position.col(first)).norm();
    if (!(span > 0.8 * apart)) {
      std::ostringstream text;
      text << "the arc lengths span " << span << ", but the points at their ends are " << apart
           << " apart: is the fourth column an arc length?";
      throw InvalidInput(text.str());
    }
  }
  if (options.intervals) {
    const Index most = std::min((2 * n - 5) / 2 - 3, most_intervals);
    if (*options.intervals < 1 || *options.intervals > most) {
      throw InvalidInput(std::to_string(*options.intervals) +
                         " intervals of a spline: must be from 1 to " + std::to_string(most) +
                         " for " + std::to_string(n) + " points");
    }
  }
}

// All starts compete on a sample of the points, first for a few steps, then the best of them.
CurveSolution best_of(const MeasuredPoints& points, const std::vector<FitStart>& starts) {
  if (starts.size() == 1) return solve_curve(points, starts.front());
  const std::vector<Index> which = sample(points.count(), most_trial_points);
  const MeasuredPoints few = chosen(points, which);
  struct Trial {
    const FitStart* start;
    double cost;
  };
  std::vector<Trial> trials;
  for (const FitStart& start : starts) trials.push_back({&start, 0});
  for (const int iterations : {4, 40}) {
    for (Trial& trial : trials) {
      FitStart start = *trial.start;
      start.feet = trial.start->feet(which);
      trial.cost = solve_curve(few, start, 0, iterations).cost;
    }
    std::stable_sort(trials.begin(), trials.end(),
                     [](const Trial& p, const Trial& q) { return p.cost < q.cost; });
    trials.resize(std::min<std::size_t>(trials.size(), 3), trials.front());
  }
  return solve_curve(points, *trials.front().start);
}

// Arcs that are known stay what they are.
void keep_arcs(const MeasuredPoints& points, FitStart& start) {
  if (points.arc.size() == 0) return;
  start.feet = points.arc;
  start.basis.first = points.arc.minCoeff();
  start.basis.last = points.arc.maxCoeff();
}

// The number of intervals by Schwarz's criterion, on means of successive points.
Index chosen_intervals(const MeasuredPoints& points) {
  const MeasuredPoints means = block_means(points).points;
  const SplineStart start(means);
  const Index residuals = (points.arc.size() > 0 ? 3 : 2) * means.count();
  Index best = 1;
  double least = std::numeric_limits<double>::infinity();
  int worse = 0;
  for (const Index intervals : interval_ladder(std::min(means.count() / 4, start.intervals()))) {
    FitStart trial = start.with_intervals(intervals);
    keep_arcs(means, trial);
    const CurveSolution solution = solve_curve(means, trial, 0, 30);
    const double criterion = schwarz_criterion(2 * solution.cost, residuals, trial.basis.size());
    if (criterion < least) {
      least = criterion;
      best = intervals;
      worse = 0;
    } else if (++worse == 3) {
      break;
    }
  }
  return best;
}

CurveSolution refined(const MeasuredPoints& points, CurveSolution solution, bool robust) {
  if (!robust) return solution;
  for (int round = 0; round < 3; ++round) {
    const double scale = points.sigma.size() > 0 ? 1 : robust_scale(solution);
    if (!(scale > 0)) break;
    solution = solve_curve(points, continued(solution), 2 * scale);
  }
  return solution;
}

// k0 as a table: of a constant one with bending about d2 alone, as for a wire of that precurvature.
DarbouxTable table_of(const CurveSolution& solution, const ShapeFit& fit, double first, double last,
                      double unit) {
  const double length = (last - first) * unit;
  if (fit.intervals == 0) {
    const bool winds = fit.numbers[1].determined;
    const Vec3 k(0, fit.numbers[0].value, winds ? fit.numbers[1].value : 0);
    return DarbouxTable({{0, k}, {length, k}});
  }
  std::vector<DarbouxRow> rows;
  const Index parts = 8 * fit.intervals;
  for (Index i = 0; i <= parts; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(parts);
    rows.push_back({share * length, solution.curve.darboux(first + share * (last - first)) / unit});
  }
  return DarbouxTable(std::move(rows));
}

Points drawn(const DarbouxCurve& curve, double first, double last, const Scaled& scale) {
  double turn = 0;
  const Index rough = 200;
  for (Index i = 0; i < rough; ++i) {
    const double arc = first + (last - first) * (static_cast<double>(i) + 0.5) / double(rough);
    turn += curve.darboux(arc).norm() * (last - first) / double(rough);
  }
  const auto count = static_cast<Index>(std::clamp(std::ceil(turn / 0.05), 50.0, 20000.0)) + 1;
  Points points(3, count);
  for (Index i = 0; i < count; ++i) {
    const double arc = first + (last - first) * static_cast<double>(i) / double(count - 1);
    points.col(i) = scale.centre + scale.unit * curve.at(arc).position;
  }
  return points;
}

ShapeFit result_of(const Scaled& scale, const CurveSolution& solution, const FitOptions& options) {
  const MeasuredPoints& points = scale.points;
  const Index n = points.count();
  const double unit = scale.unit;
  ShapeFit fit;
  fit.model = options.model;
  fit.intervals = solution.curve.basis().intervals;
  const double first = solution.feet.minCoeff(), last = solution.feet.maxCoeff();
  const Uncertainty uncertainty = uncertainty_of(points, solution);
  fit.rank = uncertainty.rank;
  fit.unknowns = uncertainty.unknowns;
  fit.degrees_of_freedom = uncertainty.degrees_of_freedom;
  const ShapeNumbers found = shape_numbers(fit.model, solution, uncertainty, first, last, unit);
  fit.numbers = found.numbers;
  fit.correlation = found.correlation;
  fit.length = (last - first) * unit;
  fit.shape.table = table_of(solution, fit, first, last, unit);
  fit.arc = (solution.feet.array() - first) * unit;
  fit.distance = solution.distance * unit;
  fit.residual_rms = std::sqrt(fit.distance.squaredNorm() / static_cast<double>(n));
  const bool weighted = points.sigma.size() > 0;
  fit.noise = uncertainty.noise * (weighted ? 1 : unit);
  if (weighted) fit.chi_square = solution.weighted_distance.squaredNorm();
  // Chance of one normal residual in so many dimensions beyond the limit: 1 / (20 n).
  const double limit =
      std::sqrt(2 * std::log(20 * static_cast<double>(n)) + double(solution.rows - 2));
  const double sigma =
      weighted ? 1 : std::max(std::min(uncertainty.noise, robust_scale(solution)), 1e-12);
  for (Index i = 0; i < n; ++i) {
    if (solution.weighted_distance[i] > limit * sigma) fit.outliers.push_back(i);
  }
  fit.converged = solution.converged;
  if (options.model == ShapeModel::circle) {
    const double around = 2 * pi * fit.numbers[2].value;
    fit.closed = fit.numbers[2].determined &&
                 around - fit.length < 3 * fit.length / static_cast<double>(n - 1);
    if (fit.closed && !points.ordered) fit.length = around;
  }
  fit.curve = drawn(solution.curve, first, last, scale);
  return fit;
}

}  // namespace

ShapeFit fit_shape(const MeasuredPoints& given, const FitOptions& options) {
  check_points(given, options);
  MeasuredPoints points = given;
  std::vector<Index> order;
  if (points.arc.size() > 0) {
    // Known arcs give the order, too.
    points.ordered = true;
    order.resize(static_cast<std::size_t>(points.count()));
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return given.arc[a] < given.arc[b]; });
  } else if (options.model != ShapeModel::circle && !points.ordered) {
    order = order_along_wire(points.position);
    if (order.empty() && options.model == ShapeModel::spline) {
      throw InvalidInput(
          "the points do not line up along one wire: a spline needs them in order, with --ordered, "
          "or with their arc lengths");
    }
  }
  if (!order.empty()) {
    points = chosen(points, order);
    points.ordered = true;
  }
  const Scaled scale = scaled(points);
  CurveSolution solution = [&] {
    if (options.model == ShapeModel::spline) {
      const SplineStart start(scale.points);
      const Index intervals =
          options.intervals ? *options.intervals : chosen_intervals(scale.points);
      FitStart one = start.with_intervals(intervals);
      keep_arcs(scale.points, one);
      return best_of(scale.points, {one});
    }
    std::vector<FitStart> starts = options.model == ShapeModel::circle
                                       ? std::vector<FitStart>{circle_start(scale.points)}
                                       : helix_starts(scale.points);
    if (options.model == ShapeModel::helix && !given.ordered && points.arc.size() == 0) {
      // an order that was found may be wrong
      MeasuredPoints loose = scale.points;
      loose.ordered = false;
      const std::vector<FitStart> more = helix_starts(loose);
      starts.insert(starts.end(), more.begin(), more.end());
    }
    for (FitStart& start : starts) keep_arcs(scale.points, start);
    return best_of(scale.points, starts);
  }();
  solution = refined(scale.points, std::move(solution), options.robust);
  ShapeFit fit = result_of(scale, solution, options);
  if (order.empty()) return fit;
  // back to the order of the file
  const Eigen::VectorXd arc = fit.arc, distance = fit.distance;
  for (std::size_t i = 0; i < order.size(); ++i) {
    fit.arc[order[i]] = arc[static_cast<Index>(i)];
    fit.distance[order[i]] = distance[static_cast<Index>(i)];
  }
  for (Index& i : fit.outliers) i = order[static_cast<std::size_t>(i)];
  std::sort(fit.outliers.begin(), fit.outliers.end());
  return fit;
}

}  // namespace wirepack
