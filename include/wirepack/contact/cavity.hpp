#pragma once

#include "wirepack/core/types.hpp"

namespace wirepack {

/// Rigid sphere about the origin.
struct SphericalCavity {
  double radius = 10;  ///< R [length]
};

/// Distance between the surface of a wire of this radius and the wall at a centreline point;
/// negative where they overlap: R - |r| - a.
inline double wall_gap(const SphericalCavity& cavity, const Vec3& point, double wire_radius) {
  return cavity.radius - point.norm() - wire_radius;
}

}  // namespace wirepack
