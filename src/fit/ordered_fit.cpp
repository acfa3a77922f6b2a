#include "ordered_fit.hpp"

#include <utility>

#include "cannot_tell.hpp"
#include "chosen_points.hpp"
#include "curve_choice.hpp"
#include "fit_uncertainty.hpp"
#include "index_lists.hpp"
#include "misfit.hpp"

namespace wirepack {

namespace {

OrderedFit fit_of_list(const MeasuredPoints& given, ListedPoints list, const FitOptions& options) {
  MeasuredPoints points = chosen(given, list.which);
  points.ordered = list.ordered;
  ScaledPoints scale = scaled_points(points);
  CurveSolution solution = nearest_curve(scale.points, options, list.order_may_be_wrong);
  return {std::move(list), std::move(scale), std::move(solution)};
}

bool winds(const CurveSolution& helix) {
  return helix.curve.darboux(0).norm() * helix.length() / (2 * pi) >= 1;
}

bool misfits(const OrderedFit& fit, ShapeModel model) {
  const Uncertainty uncertainty = uncertainty_of(fit.scale.points, fit.solution);
  return !misfit_of(model, fit.scale.points, fit.solution, uncertainty).empty();
}

// The order along a coil that the points as a set are near; empty when they are near none.
std::vector<Index> order_along_coil(const MeasuredPoints& given, const ListedPoints& list) {
  const OrderedFit coil = fit_of_list(given, list, {ShapeModel::helix, false, {}});
  const CurveSolution& solution = coil.solution;
  if (!solution.converged || !winds(solution) || !tells_turns(solution)) return {};
  if (misfits(coil, ShapeModel::helix)) return {};
  return picked(coil.list.which, order_by(solution.feet));
}

ListedPoints list_for_a_spline(const MeasuredPoints& given, ListedPoints list) {
  if (!list.order_may_be_wrong) return list;
  if (std::vector<Index> order = order_along_coil(given, list); !order.empty()) {
    return {std::move(order), true, false};
  }
  if (list.ordered) return list;
  throw cannot_tell(
      "they do not line up along one wire; a spline needs them in order, with --ordered, or with "
      "their arc lengths");
}

bool order_is_told(const OrderedFit& fit, ShapeModel model) {
  const CurveSolution& solution = fit.solution;
  if (!fit.list.order_may_be_wrong || model == ShapeModel::circle) return true;
  if (!solution.converged) return false;
  if (model == ShapeModel::helix) return !winds(solution) || tells_turns(solution);
  return !may_join_turns(solution, uncertainty_of(fit.scale.points, solution));
}

// A helix through points whose list leaves out turns, or has parts in another order: its starts
// count the turns along the list. As a set the points may tell them better.
OrderedFit better_as_a_set(const MeasuredPoints& given, OrderedFit fit, const FitOptions& options) {
  constexpr double much_nearer = 0.5;
  OrderedFit set = fit_of_list(given, {fit.list.which, false, true}, options);
  const bool nearer = set.solution.converged && order_is_told(set, options.model) &&
                      set.solution.rms_distance() < much_nearer * fit.solution.rms_distance();
  return nearer ? set : fit;
}

}  // namespace

OrderedFit ordered_fit(const MeasuredPoints& given, const std::vector<Index>& which,
                       const FitOptions& options) {
  ListedPoints list = listed_points(given, which, options.model);
  if (options.model == ShapeModel::spline) list = list_for_a_spline(given, std::move(list));
  OrderedFit fit = fit_of_list(given, std::move(list), options);
  const bool list_is_trusted = given.ordered || given.arc.size() > 0;
  if (options.model == ShapeModel::helix && fit.list.ordered && !list_is_trusted &&
      misfits(fit, options.model)) {
    fit = better_as_a_set(given, std::move(fit), options);
  }
  if (!order_is_told(fit, options.model)) throw cannot_tell(no_order);
  return fit;
}

}  // namespace wirepack
