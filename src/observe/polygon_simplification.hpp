#pragma once

#include "wirepack/core/types.hpp"

namespace wirepack {

/// A closed polygon of the same knot with fewer corners: cuts off, in turn, every corner whose
/// triangle no other edge meets, until none is left (Koniaris & Muthukumar 1991; Taylor 2000).
Points simplified_polygon(const Points& polygon);

}  // namespace wirepack
