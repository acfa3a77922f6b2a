#pragma once

#include <optional>

#include "wirepack/fit/measured_points.hpp"

#include "block_means.hpp"
#include "fit_start.hpp"

namespace wirepack {

/// Where the fit of a spline to ordered points begins: near a line along at most so many means of
/// them, with as many intervals as are given, or as Schwarz's criterion wants. With fewer means
/// than by default the points are taken for one line, and not for a coil.
FitStart spline_start(const MeasuredPoints& points, const std::optional<Index>& intervals,
                      Index most_means = most_block_means);

}  // namespace wirepack
