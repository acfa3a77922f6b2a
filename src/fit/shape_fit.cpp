#include "wirepack/fit/shape_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <tuple>

#include "wirepack/core/error.hpp"

#include "curve_problem.hpp"
#include "point_order.hpp"
#include "starting_values.hpp"

namespace wirepack {

namespace {

constexpr Index most_trial_points = 200;  // on which starts compete
constexpr Index most_intervals = 96;
constexpr double straight_significance = 11.8;  // chi^2 of two numbers, as rare as three sigma

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

// Distances, over the sigmas where there are any, are scattered about zero like this.
double robust_scale(const CurveSolution& solution) {
  std::vector<double> sizes(solution.weighted_distance.data(),
                            solution.weighted_distance.data() + solution.weighted_distance.size());
  std::nth_element(sizes.begin(), sizes.begin() + std::ssize(sizes) / 2, sizes.end());
  // medians of |r| for normal r in two and in three dimensions
  return sizes[sizes.size() / 2] / (solution.rows == 2 ? 1.17741 : 1.53817);
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

/// Covariance of the unknowns (with those of the pose), and what of them the points do not tell.
struct Uncertainty {
  Eigen::MatrixXd covariance;
  Eigen::MatrixXd unknown_directions;
  Index rank, unknowns, degrees_of_freedom;
  double noise;
};

Uncertainty uncertainty_of(const MeasuredPoints& points, const CurveSolution& solution) {
  const Index size = solution.jacobian.cols();
  std::vector<Index> free;
  for (Index i = 0; i < size; ++i) {
    if (i != DarbouxCurve::shift_along || solution.rows == 3) free.push_back(i);
  }
  const Eigen::MatrixXd jacobian = solution.jacobian(Eigen::all, free);
  // R of a QR decomposition has the singular values of the Jacobian and few rows.
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(jacobian);
  const Eigen::MatrixXd r = qr.matrixR().topRows(jacobian.cols()).triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(r, Eigen::ComputeFullV);
  const Eigen::MatrixXd directions = qr.colsPermutation() * svd.matrixV();
  const Eigen::VectorXd& values = svd.singularValues();
  Uncertainty result;
  result.unknowns = jacobian.cols();
  result.rank = (values.array() > 1e-9 * values[0]).count();
  result.degrees_of_freedom = jacobian.rows() - result.rank;
  // Huber's proposal: variance of the bounded residuals over the square of their mean derivative,
  // which are the sum of squares and 1 without a bound.
  double squares = 0, derivative = 0;
  for (const double r2 : solution.weighted_distance) {
    const bool far = solution.huber > 0 && r2 > solution.huber;
    squares += far ? solution.huber * solution.huber : r2 * r2;
    derivative += far ? solution.huber / r2 * (1 - 1.0 / static_cast<double>(solution.rows)) : 1;
  }
  derivative /= static_cast<double>(points.count());
  const double rounding = 1e-16;  // of points in units of their extent
  const double variance = squares /
                          static_cast<double>(std::max<Index>(result.degrees_of_freedom, 1)) /
                          (derivative * derivative);
  const bool given = points.sigma.size() > 0;
  result.noise = given ? std::sqrt(variance) : std::max(std::sqrt(variance), rounding);
  const double scale = given && !(solution.huber > 0) ? 1 : result.noise;
  const Index kept = result.rank;
  const Eigen::MatrixXd half =
      directions.leftCols(kept) * values.head(kept).cwiseInverse().asDiagonal();
  const Eigen::MatrixXd of_free = scale * scale * (half * half.transpose());
  result.covariance = Eigen::MatrixXd::Zero(size, size);
  result.covariance(free, free) = of_free;
  result.unknown_directions = Eigen::MatrixXd::Zero(size, result.unknowns - kept);
  result.unknown_directions(free, Eigen::all) = directions.rightCols(result.unknowns - kept);
  return result;
}

/// Numbers of a shape as functions of the unknowns: curvature, torsion[, radius, pitch].
Eigen::VectorXd shape_numbers(ShapeModel model, const DarbouxCurve& curve,
                              const Eigen::VectorXd& unknowns, double first, double last) {
  if (model != ShapeModel::spline) {
    const Vec3 k = curve.basis().darboux(unknowns, 0);
    const double curvature = k.head<2>().norm(), torsion = k.z();
    const double rate2 = curvature * curvature + torsion * torsion;
    return Eigen::Vector4d(curvature, torsion, curvature / rate2, 2 * pi * torsion / rate2);
  }
  // Means along the wire. In frames without twist, torsion is the rate at which the direction of
  // bending turns.
  const Index parts = 32 * curve.basis().intervals;
  const double step = (last - first) / static_cast<double>(parts);
  double curvature = 0, turn = 0;
  Vec3 before = curve.basis().darboux(unknowns, first);
  for (Index i = 0; i < parts; ++i) {
    const double arc = first + step * static_cast<double>(i);
    curvature += curve.basis().darboux(unknowns, arc + step / 2).norm();
    const Vec3 after = curve.basis().darboux(unknowns, arc + step);
    turn += std::atan2(before.cross(after).z(), before.dot(after));
    before = after;
  }
  return Eigen::Vector2d(curvature / static_cast<double>(parts), turn / (last - first));
}

// The curvature differs from 0 by more than its errors, all along the curve.
bool is_bent(const CurveSolution& solution, const Uncertainty& uncertainty, double first,
             double last) {
  const DarbouxBasis& basis = solution.curve.basis();
  const Index samples = basis.intervals > 0 ? 4 * basis.intervals + 1 : 1;
  for (Index i = 0; i < samples; ++i) {
    const double arc = samples > 1 ? first + (last - first) * static_cast<double>(i) /
                                                 static_cast<double>(samples - 1)
                                   : 0;
    Eigen::Matrix2Xd rows = Eigen::Matrix2Xd::Zero(2, solution.curve.size());
    for (const auto& w : basis.weights(arc)) {
      if (w.component < 2) rows(w.component, DarbouxCurve::pose_size + w.unknown) = w.value;
    }
    const Eigen::Vector2d k = rows * solution.curve.unknowns();
    const Eigen::Matrix2d covariance = rows * uncertainty.covariance * rows.transpose();
    if (!(k.norm() > 1e-9)) return false;
    if (!(k.dot(covariance.fullPivLu().solve(k)) > straight_significance)) return false;
  }
  return true;
}

void fill_numbers(const CurveSolution& solution, const Uncertainty& uncertainty, double first,
                  double last, double unit, ShapeFit& fit) {
  const Eigen::VectorXd& unknowns = solution.curve.unknowns();
  const Eigen::VectorXd values = shape_numbers(fit.model, solution.curve, unknowns, first, last);
  const bool bent = is_bent(solution, uncertainty, first, last);
  const Index count = values.size();
  Eigen::MatrixXd by_unknown = Eigen::MatrixXd::Zero(count, unknowns.size());
  for (Index i = DarbouxCurve::pose_size; i < unknowns.size(); ++i) {
    const double h = 1e-5 * std::max(1e-3, unknowns.tail(solution.curve.basis().size()).norm());
    Eigen::VectorXd up = unknowns, down = unknowns;
    up[i] += h;
    down[i] -= h;
    by_unknown.col(i) = (shape_numbers(fit.model, solution.curve, up, first, last) -
                         shape_numbers(fit.model, solution.curve, down, first, last)) /
                        (2 * h);
  }
  Eigen::MatrixXd covariance = by_unknown * uncertainty.covariance * by_unknown.transpose();
  const std::array<const char*, 4> names{"curvature", "torsion", "radius", "pitch"};
  const std::array<double, 4> units{1 / unit, 1 / unit, unit, unit};
  std::vector<bool> counts;
  for (Index i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    ShapeNumber number{names[k], values[i] * units[k], std::sqrt(covariance(i, i)) * units[k]};
    number.fixed = fit.model == ShapeModel::circle && (i == 1 || i == 3);
    const bool hidden = uncertainty.unknown_directions.cols() > 0 &&
                        (by_unknown.row(i) * uncertainty.unknown_directions).norm() >
                            1e-6 * by_unknown.row(i).norm();
    number.determined = number.fixed || (!hidden && (bent || i == 0));
    if (i == 0 && !bent && fit.model != ShapeModel::spline) {
      // the length of (k1, k2) has no derivative at 0; either component has this error
      const auto block =
          uncertainty.covariance.block<2, 2>(DarbouxCurve::pose_size, DarbouxCurve::pose_size);
      number.standard_error = std::sqrt(block.trace() / 2) * units[k];
    }
    counts.push_back(number.determined && !number.fixed);
    fit.numbers.push_back(number);
  }
  fit.correlation = Eigen::MatrixXd::Zero(count, count);
  for (Index i = 0; i < count; ++i) {
    for (Index j = 0; j < count; ++j) {
      if (!counts[static_cast<std::size_t>(i)] || !counts[static_cast<std::size_t>(j)]) continue;
      fit.correlation(i, j) = covariance(i, j) / std::sqrt(covariance(i, i) * covariance(j, j));
    }
  }
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
  fill_numbers(solution, uncertainty, first, last, unit, fit);
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
