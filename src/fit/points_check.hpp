#pragma once

#include "wirepack/fit/measured_points.hpp"
#include "wirepack/fit/shape_fit.hpp"

namespace wirepack {

/// The least number of different points that tell a model with its errors.
Index fewest_points(ShapeModel model);

/// Throws InvalidInput, with the reason, for points that cannot tell the model: too few different
/// ones, arc lengths shorter than the way between the points, more intervals than points for them.
void check_points(const MeasuredPoints& points, const FitOptions& options);

}  // namespace wirepack
