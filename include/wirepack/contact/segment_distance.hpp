#pragma once

#include "wirepack/core/types.hpp"

namespace wirepack {

/// Squared distance between the segments p0 p1 and q0 q1; exact also when they are parallel or
/// have no length.
double squared_segment_distance(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1);

}  // namespace wirepack
