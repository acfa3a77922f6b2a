#include "wirepack/fit/shape_fit.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "wirepack/core/error.hpp"

#include "curve_choice.hpp"
#include "far_points.hpp"
#include "fit_uncertainty.hpp"
#include "misfit.hpp"
#include "point_order.hpp"
#include "points_check.hpp"
#include "shape_numbers.hpp"

namespace wirepack {

namespace {

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
  result.points.resolution = points.resolution / result.unit;
  if (points.sigma.size() > 0) result.points.sigma = points.sigma / result.unit;
  return result;
}

Vec3 in_scale(const Scaled& scale, const Vec3& point) {
  return (point - scale.centre) / scale.unit;
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

// The points that are fitted, in the order in which they are.
struct Listed {
  std::vector<Index> which;
  bool ordered = false, order_may_be_wrong = false;
};

std::vector<Index> through(const std::vector<Index>& outer, const std::vector<Index>& inner) {
  std::vector<Index> result;
  for (const Index i : inner) result.push_back(outer[static_cast<std::size_t>(i)]);
  return result;
}

Listed listed(const MeasuredPoints& points, std::vector<Index> which, ShapeModel model) {
  if (points.arc.size() > 0) {  // known arcs give the order, too
    std::stable_sort(which.begin(), which.end(),
                     [&](Index a, Index b) { return points.arc[a] < points.arc[b]; });
    return {which, true, false};
  }
  if (points.ordered) return {which, true, false};
  const Points position = points.position(Eigen::all, which);
  if (const std::vector<Index> order = order_of_list(position); !order.empty()) {
    return {through(which, order), true, false};
  }
  if (model == ShapeModel::circle) return {which, false, true};
  const std::vector<Index> order = order_along_wire(position);
  if (!order.empty()) return {through(which, order), true, true};
  return {which, false, true};
}

/// A curve through those of the points that are not left out.
struct Fitted {
  Listed listed;
  Scaled scale;
  CurveSolution solution;
};

Fitted fitted(const MeasuredPoints& given, Listed list, const FitOptions& options) {
  MeasuredPoints points = chosen(given, list.which);
  points.ordered = list.ordered;
  Scaled scale = scaled(points);
  CurveSolution solution = nearest_curve(scale.points, options, list.order_may_be_wrong);
  return {std::move(list), std::move(scale), std::move(solution)};
}

double turns_of(const CurveSolution& solution) {
  return solution.curve.darboux(0).norm() * (solution.feet.maxCoeff() - solution.feet.minCoeff()) /
         (2 * pi);
}

// The order along a coil that the points as a set are near; empty when they are near none.
std::vector<Index> order_along_coil(const MeasuredPoints& given, const Listed& list) {
  const Fitted coil = fitted(given, list, {ShapeModel::helix, false, {}});
  const CurveSolution& solution = coil.solution;
  if (!solution.converged || turns_of(solution) < 1 || !tells_turns(solution)) return {};
  const Uncertainty uncertainty = uncertainty_of(coil.scale.points, solution);
  const bool fits = misfit_of(ShapeModel::helix, coil.scale.points, solution, uncertainty).empty();
  if (!fits) return {};
  std::vector<Index> order(list.which.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return solution.feet[a] < solution.feet[b]; });
  return through(coil.listed.which, order);
}

constexpr const char* no_order =
    "they come in no order that tells turns apart; give them in order, with --ordered, or with "
    "their arc lengths";

Fitted fitted(const MeasuredPoints& given, const std::vector<Index>& kept,
              const FitOptions& options) {
  Listed list = listed(given, kept, options.model);
  if (options.model == ShapeModel::spline && list.order_may_be_wrong) {
    if (std::vector<Index> order = order_along_coil(given, list); !order.empty()) {
      list = {std::move(order), true, false};
    } else if (!list.ordered) {
      throw InvalidInput(
          "the points do not line up along one wire: a spline needs them in order, with --ordered, "
          "or with their arc lengths");
    }
  }
  Fitted fit = fitted(given, std::move(list), options);
  if (!fit.listed.order_may_be_wrong || options.model == ShapeModel::circle) return fit;
  const CurveSolution& solution = fit.solution;
  const bool told = options.model == ShapeModel::helix
                        ? turns_of(solution) < 1 || tells_turns(solution)
                        : !may_join_turns(solution, uncertainty_of(fit.scale.points, solution));
  if (!told || !solution.converged) {
    throw InvalidInput(std::string("the points cannot tell the shape: ") + no_order);
  }
  return fit;
}

// Arc of the place on the curve that is nearest to a point, which may be anywhere.
double nearest_arc(const DarbouxCurve& curve, double first, double last, const Vec3& point) {
  constexpr Index places = 2000;
  double arc = first, least = std::numeric_limits<double>::infinity();
  const auto distance = [&](double s) { return (curve.at(s).position - point).norm(); };
  for (Index i = 0; i <= places; ++i) {
    const double s = first + (last - first) * static_cast<double>(i) / places;
    if (distance(s) >= least) continue;
    least = distance(s);
    arc = s;
  }
  const double foot = curve.foot(point, arc);
  return distance(foot) < least ? foot : arc;
}

// The curve goes on from its end to its start, and is not open by more than the usual step there.
bool closes(const CurveSolution& solution, double first, double last, double gap) {
  const DarbouxCurve::Pose start = solution.curve.at(first), end = solution.curve.at(last);
  const double step = (last - first) / static_cast<double>(solution.feet.size() - 1);
  const Vec3 way = start.position - end.position;
  const Vec3 tangent = end.directors.col(2);
  const bool straight_on = way.dot(tangent) > 0.7 * way.norm() || way.norm() < 0.1 * step;
  const bool smooth = start.directors.col(2).dot(tangent) > 0.5 && straight_on;
  return last - first > 6 * gap && gap < 3 * step && smooth;
}

// Beyond what one normal residual of so many exceeds with a chance of 1 in 20, and beyond rounding.
std::vector<Index> outliers_of(ShapeModel model, const MeasuredPoints& points,
                               const CurveSolution& solution, const Uncertainty& uncertainty) {
  const auto n = static_cast<double>(points.count());
  const Index dimensions = uncertainty.dimensions;
  const double limit = std::sqrt(2 * std::log(20 * n) + static_cast<double>(dimensions - 2));
  const double usual =
      std::max(median_scale(solution, dimensions), upper_scale(solution, dimensions));
  const double sigma =
      points.sigma.size() > 0 ? 1 : std::max(std::min(uncertainty.noise, usual), 1e-12);
  std::vector<Index> outliers;
  for (Index i = 0; i < points.count(); ++i) {
    const bool far = solution.weighted_distance[i] > limit * sigma;
    const double least = std::max(points.resolution, finest_residual(model));
    if (far && solution.distance[i] > least) outliers.push_back(i);
  }
  return outliers;
}

// Arc and distance of all points, of those that are left out, too.
void place_points(const Fitted& fitted, const MeasuredPoints& given, const std::vector<Index>& far,
                  ShapeFit& fit) {
  const CurveSolution& solution = fitted.solution;
  const double first = solution.feet.minCoeff(), last = solution.feet.maxCoeff();
  fit.arc.resize(given.count());
  fit.distance.resize(given.count());
  const auto put = [&](Index i, double arc, double distance) {
    fit.arc[i] = (arc - first) * fitted.scale.unit;
    fit.distance[i] = distance * fitted.scale.unit;
  };
  for (std::size_t k = 0; k < fitted.listed.which.size(); ++k) {
    const auto here = static_cast<Index>(k);
    put(fitted.listed.which[k], solution.feet[here], solution.distance[here]);
  }
  for (const Index i : far) {
    const Vec3 point = in_scale(fitted.scale, given.position.col(i));
    const double arc = nearest_arc(solution.curve, first, last, point);
    put(i, arc, (solution.curve.at(arc).position - point).norm());
  }
}

// Points all around: in no given order, the gap between the last and the first is wire as well.
void note_closure(const Fitted& fitted, bool order_given, double first, double last,
                  ShapeFit& fit) {
  const double unit = fitted.scale.unit;
  double gap = 0;
  if (fit.model == ShapeModel::helix) return;
  if (fit.model == ShapeModel::circle) {
    if (!fit.numbers[2].determined) return;
    const double around = 2 * pi * fit.numbers[2].value / unit;
    const double step = (last - first) / static_cast<double>(fitted.solution.feet.size() - 1);
    gap = around - (last - first);
    fit.closed = gap < 3 * step;
  } else {
    const DarbouxCurve& curve = fitted.solution.curve;
    gap = (curve.at(first).position - curve.at(last).position).norm();
    fit.closed = closes(fitted.solution, first, last, gap);
  }
  if (fit.closed && !order_given && gap > 0) fit.length += gap * unit;
}

// In no given order, a point far off may be taken for a turn that is not there: one may be an error
// of measurement, one of fifty says that the line through all of them cannot be trusted.
void require_outliers_are_few(const Fitted& fitted, const ShapeFit& fit, Index count) {
  if (!fitted.listed.order_may_be_wrong || fit.model == ShapeModel::circle) return;
  const auto far = static_cast<Index>(fit.outliers.size());
  if (far < 2 || 50 * far < count) return;
  throw InvalidInput(fmt::format("the points cannot tell the shape: {} of {} lie far off, and {}",
                                 far, count, no_order));
}

ShapeFit result_of(const Fitted& fitted, const MeasuredPoints& given, const std::vector<Index>& far,
                   const FitOptions& options) {
  const Scaled& scale = fitted.scale;
  const CurveSolution& solution = fitted.solution;
  const MeasuredPoints& points = scale.points;
  const std::vector<Index>& which = fitted.listed.which;
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
  fit.residual_rms = unit * std::sqrt(solution.distance.squaredNorm() / static_cast<double>(n));
  const bool weighted = points.sigma.size() > 0;
  fit.noise = uncertainty.noise * (weighted ? 1 : unit);
  if (weighted) fit.chi_square = solution.weighted_distance.squaredNorm();
  fit.planar = uncertainty.planar;
  fit.misfit = misfit_of(fit.model, points, solution, uncertainty);
  fit.converged = solution.converged && std::isfinite(fit.length);
  place_points(fitted, given, far, fit);
  fit.left_out = far;
  fit.outliers = far;
  for (const Index k : outliers_of(fit.model, points, solution, uncertainty)) {
    fit.outliers.push_back(which[static_cast<std::size_t>(k)]);
  }
  std::sort(fit.outliers.begin(), fit.outliers.end());
  require_outliers_are_few(fitted, fit, n);
  note_closure(fitted, given.ordered || given.arc.size() > 0, first, last, fit);
  fit.curve = drawn(solution.curve, first, last, scale);
  return fit;
}

// Points far from all others, or from their neighbours in the list.
std::vector<Index> errors_of_measurement(const Points& points) {
  std::vector<Index> found;
  const std::vector<Index> far = far_points(points), spikes = spikes_of_list(points);
  std::set_union(far.begin(), far.end(), spikes.begin(), spikes.end(), std::back_inserter(found));
  return found;
}

bool lies_on(const Fitted& fitted, const Vec3& given) {
  const CurveSolution& solution = fitted.solution;
  const Vec3 point = in_scale(fitted.scale, given);
  const double first = solution.feet.minCoeff(), last = solution.feet.maxCoeff();
  const double length = last - first;
  const double arc = nearest_arc(solution.curve, first - length / 2, last + length / 2, point);
  const double off = (solution.curve.at(arc).position - point).norm();
  const double rms = std::sqrt(solution.distance.squaredNorm() / double(solution.distance.size()));
  return off < std::max(5 * rms, 1e-9);
}

}  // namespace

ShapeFit fit_shape(const MeasuredPoints& given, const FitOptions& options) {
  std::vector<Index> far = errors_of_measurement(given.position);
  if (given.count() - std::ssize(far) < fewest_points(options.model)) far.clear();
  const auto kept_of = [&] {
    std::vector<Index> kept;
    for (Index i = 0; i < given.count(); ++i) {
      if (!std::binary_search(far.begin(), far.end(), i)) kept.push_back(i);
    }
    return kept;
  };
  std::vector<Index> kept = kept_of();
  check_points(chosen(given, kept), options);
  Fitted fit = fitted(given, kept, options);
  // what stands alone, but on the curve, is no error
  if (std::erase_if(far, [&](Index i) { return lies_on(fit, given.position.col(i)); }) > 0) {
    fit = fitted(given, kept_of(), options);
  }
  return result_of(fit, given, far, options);
}

}  // namespace wirepack
