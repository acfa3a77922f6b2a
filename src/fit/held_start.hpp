#pragma once

#include "wirepack/fit/measured_points.hpp"

#include "fit_start.hpp"

namespace wirepack {

/// The start, brought near its points with each of them held at the arc of its foot. Errors of k0
/// add up along a curve, and feet that are free may then end on another turn of a coil.
FitStart held_start(const MeasuredPoints& points, FitStart start);

}  // namespace wirepack
