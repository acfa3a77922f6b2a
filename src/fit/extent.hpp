#pragma once

#include "wirepack/core/types.hpp"

namespace wirepack {

/// Edges of the box along the coordinates around points.
inline Vec3 box_of(const Points& points) {
  return points.rowwise().maxCoeff() - points.rowwise().minCoeff();
}

/// The diagonal of that box.
inline double extent_of(const Points& points) { return box_of(points).norm(); }

}  // namespace wirepack
