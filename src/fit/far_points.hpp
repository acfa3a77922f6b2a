#pragma once

#include <vector>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// Points that stand alone: few, with no other point within several times the largest distance that
/// any of the rest has from its nearest neighbour. One such error of measurement would be all that
/// a least square sees.
std::vector<Index> far_points(const Points& points);

}  // namespace wirepack
