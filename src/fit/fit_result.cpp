#include "fit_result.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "closure.hpp"
#include "curve_places.hpp"
#include "fit_outliers.hpp"
#include "fit_uncertainty.hpp"
#include "index_lists.hpp"
#include "misfit.hpp"
#include "shape_numbers.hpp"

namespace wirepack {

namespace {

// k0 of a constant one with bending about d2 alone, as for a wire of that precurvature.
DarbouxTable constant_table(const std::vector<ShapeNumber>& numbers, double length) {
  const Vec3 k(0, numbers[0].value, numbers[1].determined ? numbers[1].value : 0);
  return DarbouxTable({{0, k}, {length, k}});
}

DarbouxTable table_along(const CurveSolution& solution, double unit) {
  const double first = solution.first(), length = solution.length();
  const Index parts = 8 * solution.curve.basis().intervals;
  std::vector<DarbouxRow> rows;
  for (Index i = 0; i <= parts; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(parts);
    rows.push_back(
        {share * (length * unit), solution.curve.darboux(first + share * length) / unit});
  }
  return DarbouxTable(std::move(rows));
}

void put_shape(const OrderedFit& from, const Uncertainty& uncertainty, ShapeFit& fit) {
  const CurveSolution& solution = from.solution;
  const double first = solution.first(), last = solution.last(), unit = from.scale.unit;
  const ShapeNumbers found = shape_numbers(fit.model, solution, uncertainty, first, last, unit);
  fit.numbers = found.numbers;
  fit.correlation = found.correlation;
  fit.length = solution.length() * unit;
  fit.intervals = solution.curve.basis().intervals;
  fit.shape.table =
      fit.intervals == 0 ? constant_table(fit.numbers, fit.length) : table_along(solution, unit);
  fit.curve = drawn(solution.curve, first, last, from.scale);
}

void put_quality(const OrderedFit& from, const Uncertainty& uncertainty, ShapeFit& fit) {
  const CurveSolution& solution = from.solution;
  const double unit = from.scale.unit;
  const bool weighted = from.scale.points.sigma.size() > 0;
  fit.rank = uncertainty.rank;
  fit.unknowns = uncertainty.unknowns;
  fit.degrees_of_freedom = uncertainty.degrees_of_freedom;
  fit.residual_rms = unit * solution.rms_distance();
  fit.noise = uncertainty.noise * (weighted ? 1 : unit);
  if (weighted) fit.chi_square = solution.weighted_distance.squaredNorm();
  fit.planar = uncertainty.planar;
  fit.misfit = misfit_of(fit.model, from.scale.points, solution, uncertainty);
  fit.converged = solution.converged && std::isfinite(fit.length);
}

// Arc and distance of all points, of those that are left out, too.
void put_places(const OrderedFit& from, const MeasuredPoints& given,
                const std::vector<Index>& left_out, ShapeFit& fit) {
  const CurveSolution& solution = from.solution;
  const double unit = from.scale.unit, first = solution.first();
  fit.arc.resize(given.count());
  fit.distance.resize(given.count());
  const auto put = [&](Index i, double arc, double distance) {
    fit.arc[i] = (arc - first) * unit;
    fit.distance[i] = distance * unit;
  };
  for (Index k = 0; k < solution.feet.size(); ++k) {
    put(from.list.which[static_cast<std::size_t>(k)], solution.feet[k], solution.distance[k]);
  }
  for (const Index i : left_out) {
    const Vec3 point = from.scale.scaled(given.position.col(i));
    const double arc = nearest_arc(solution.curve, first, solution.last(), point);
    put(i, arc, (solution.curve.at(arc).position - point).norm());
  }
}

void put_outliers(const OrderedFit& from, const Uncertainty& uncertainty,
                  const std::vector<Index>& left_out, ShapeFit& fit) {
  fit.left_out = left_out;
  fit.outliers = picked(from.list.which, outliers_of(fit.model, from, uncertainty));
  fit.outliers.insert(fit.outliers.end(), left_out.begin(), left_out.end());
  std::sort(fit.outliers.begin(), fit.outliers.end());
}

// In no given order, the gap between the last point and the first is wire as well.
void put_closure(const OrderedFit& from, bool order_given, ShapeFit& fit) {
  const double unit = from.scale.unit;
  const Closure closure = closure_of(fit.model, from.solution, fit.numbers, unit);
  fit.closed = closure.closed;
  if (fit.closed && !order_given && closure.gap > 0) fit.length += closure.gap * unit;
}

}  // namespace

ShapeFit fit_result(const OrderedFit& from, const MeasuredPoints& given,
                    const std::vector<Index>& left_out, ShapeModel model) {
  ShapeFit fit;
  fit.model = model;
  const Uncertainty uncertainty = uncertainty_of(from.scale.points, from.solution);
  put_shape(from, uncertainty, fit);
  put_quality(from, uncertainty, fit);
  put_places(from, given, left_out, fit);
  put_outliers(from, uncertainty, left_out, fit);
  if (from.list.order_may_be_wrong && model != ShapeModel::circle) {
    require_outliers_are_few(std::ssize(fit.outliers), given.count());
  }
  put_closure(from, given.ordered || given.arc.size() > 0, fit);
  return fit;
}

}  // namespace wirepack
