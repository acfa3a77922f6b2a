#pragma once

#include <optional>

#include "wirepack/fit/measured_points.hpp"

#include "fit_start.hpp"

namespace wirepack {

/// Where the fit of a spline to ordered points begins: near a line along means of them, with as
/// many intervals as are given, or as Schwarz's criterion wants.
FitStart spline_start(const MeasuredPoints& points, const std::optional<Index>& intervals);

}  // namespace wirepack
