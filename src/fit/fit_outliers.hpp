#pragma once

#include <vector>

#include "wirepack/fit/measured_points.hpp"
#include "wirepack/fit/shape_fit.hpp"

#include "fit_uncertainty.hpp"
#include "ordered_fit.hpp"

namespace wirepack {

/// Points that a fit had better do without: far from all others, or from their neighbours in the
/// list.
std::vector<Index> errors_of_measurement(const Points& points);

/// A point that is not part of the fit is near the curve, or where that goes on, for all that.
bool lies_on(const OrderedFit& fit, const Vec3& given);

/// Places in the list of those that are part of the fit, but off by more than one normal residual
/// of so many is with a chance of 1 in 20, and by more than rounding.
std::vector<Index> outliers_of(ShapeModel model, const OrderedFit& fit,
                               const Uncertainty& uncertainty);

/// In no given order, a point far off may be taken for a turn that is not there: one may be an
/// error of measurement, one of fifty says that the line through all of them cannot be trusted.
/// Throws InvalidInput; of `given` points, also those that are no part of the fit count.
void require_outliers_are_few(Index outliers, Index given);

}  // namespace wirepack
