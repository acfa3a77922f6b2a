#pragma once

#include <string>

#include "wirepack/fit/measured_points.hpp"
#include "wirepack/fit/shape_fit.hpp"

#include "curve_problem.hpp"
#include "fit_uncertainty.hpp"

namespace wirepack {

/// Residuals over the extent of the points that say nothing: round-off, or the detail that a spline
/// leaves out.
constexpr double finest_residual(ShapeModel model) {
  return model == ShapeModel::spline ? 1e-5 : 1e-9;
}

/// How the residuals of a fit show that they are not scatter: neighbours that lie off to the same
/// side, a circle that the points leave along its axis more than in its plane, a chi square far
/// above its degrees of freedom. Empty when they could be scatter, or are not above the rounding of
/// the points.
std::string misfit_of(ShapeModel model, const MeasuredPoints& points, const CurveSolution& solution,
                      const Uncertainty& uncertainty);

/// Correlation of the residuals of neighbours along the curve: near 0 for scatter, near 1 for a
/// curve of too few unknowns.
double neighbour_correlation(const CurveSolution& solution);

/// False when points scatter along the axis of a helix by so much that turns of another number, or
/// of the other hand, would fit as well; for points in no order.
bool tells_turns(const CurveSolution& solution);

/// The curve may run between turns of a coil that lie side by side, as points that are in no order
/// could be joined across them: they scatter along the binormal more than along the normal.
bool may_join_turns(const CurveSolution& solution, const Uncertainty& uncertainty);

}  // namespace wirepack
