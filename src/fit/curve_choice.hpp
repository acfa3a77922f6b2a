#pragma once

#include "wirepack/fit/measured_points.hpp"
#include "wirepack/fit/shape_fit.hpp"

#include "curve_problem.hpp"

namespace wirepack {

/// The curve of a model that is nearest to points: starts, intervals, least squares. The points of
/// a spline must be ordered. Where the order was only found, as it may be wrong, a helix is also
/// looked for in the points as a set.
CurveSolution nearest_curve(const MeasuredPoints& points, const FitOptions& options,
                            bool order_may_be_wrong);

}  // namespace wirepack
