#pragma once

#include <vector>

#include "wirepack/fit/measured_points.hpp"

namespace wirepack {

/// Some of the points, in the order of `which`.
MeasuredPoints chosen(const MeasuredPoints& points, const std::vector<Index>& which);

}  // namespace wirepack
