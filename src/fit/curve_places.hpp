#pragma once

#include "wirepack/core/types.hpp"
#include "wirepack/fit/darboux_curve.hpp"

#include "scaled_points.hpp"

namespace wirepack {

/// Arc, from first to last or a little beyond, of the place on the curve that is nearest to a
/// point, which may be anywhere.
double nearest_arc(const DarbouxCurve& curve, double first, double last, const Vec3& point);

/// Mean of the size of k0 between two arcs, by so many samples.
double mean_turning(const DarbouxCurve& curve, double first, double last, Index samples);

/// Places so close that the curve turns little from one to the next, in the unit of the points
/// given.
Points drawn(const DarbouxCurve& curve, double first, double last, const ScaledPoints& scale);

}  // namespace wirepack
