#pragma once

#include <vector>

#include "wirepack/fit/measured_points.hpp"
#include "wirepack/fit/shape_fit.hpp"

namespace wirepack {

/// Points that are fitted, in the order in which they are.
struct ListedPoints {
  std::vector<Index> which;
  bool ordered = false;             ///< along a wire
  bool order_may_be_wrong = false;  ///< it was not given, but found from the points as a set
};

/// Some of the points in the order that is given, or that the list or their places tell.
ListedPoints listed_points(const MeasuredPoints& points, const std::vector<Index>& which,
                           ShapeModel model);

}  // namespace wirepack
