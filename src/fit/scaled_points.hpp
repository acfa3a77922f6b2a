#pragma once

#include "wirepack/core/types.hpp"
#include "wirepack/fit/measured_points.hpp"

namespace wirepack {

/// Points about their middle, in units of their extent: then all unknowns are of order 1.
struct ScaledPoints {
  MeasuredPoints points;
  Vec3 centre;
  double unit;

  Vec3 scaled(const Vec3& given) const { return (given - centre) / unit; }
  Vec3 given(const Vec3& scaled) const { return centre + unit * scaled; }
};

ScaledPoints scaled_points(const MeasuredPoints& given);

}  // namespace wirepack
