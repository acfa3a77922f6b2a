#pragma once

#include <string>

#include "wirepack/fit/measured_points.hpp"
#include "wirepack/fit/shape_fit.hpp"

#include "curve_problem.hpp"
#include "fit_uncertainty.hpp"

namespace wirepack {

/// How the residuals of a fit show that they are not scatter: neighbours that lie off to the same
/// side, a circle that the points leave along its axis more than in its plane, a chi square far above
/// its degrees of freedom. Empty when they could be scatter, or are not above the rounding of the points.
std::string misfit_of(ShapeModel model, const MeasuredPoints& points, const CurveSolution& solution,
                      const Uncertainty& uncertainty);

/// Throws InvalidInput when points in no order scatter along the axis of a helix by so much that turns
/// of another number, or of the other hand, would fit as well.
void check_turns(const CurveSolution& solution);

}  // namespace wirepack
