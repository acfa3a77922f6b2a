#pragma once

#include <vector>

#include "wirepack/fit/measured_points.hpp"

#include "fit_start.hpp"

namespace wirepack {

/// The algebraic circle (Taubin 1991) in the plane of the points, or a straight line.
FitStart circle_start(const MeasuredPoints& points);

/// Helices around several possible axes, with the circle, and the circle with some torsion of
/// either hand for short arcs; one of them is near the best fit.
std::vector<FitStart> helix_starts(const MeasuredPoints& points);

}  // namespace wirepack
