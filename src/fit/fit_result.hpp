#pragma once

#include <vector>

#include "wirepack/fit/measured_points.hpp"
#include "wirepack/fit/shape_fit.hpp"

#include "ordered_fit.hpp"

namespace wirepack {

/// The shape of a fit `from` points, in the unit of the points given, and how well they tell it.
/// `left_out` are those that are no part of the fit. Throws InvalidInput when outliers make its
/// order doubtful.
ShapeFit fit_result(const OrderedFit& from, const MeasuredPoints& given,
                    const std::vector<Index>& left_out, ShapeModel model);

}  // namespace wirepack
