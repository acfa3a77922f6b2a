#pragma once

#include <cmath>

#include "wirepack/core/triple.hpp"
#include "wirepack/core/types.hpp"

namespace wirepack {

/// Rigid sphere about the origin.
struct SphericalCavity {
  double radius = 10;  ///< R [length]
};

/// Distance between the surface of a wire of this radius and the wall at a centreline point;
/// negative where they overlap: R - |r| - a.
template <class T>
T wall_gap(const SphericalCavity& cavity, const Triple<T>& point, double wire_radius) {
  using std::sqrt;
  return cavity.radius - sqrt(dot(point, point)) - wire_radius;
}
inline double wall_gap(const SphericalCavity& cavity, const Vec3& point, double wire_radius) {
  return wall_gap(cavity, triple(point), wire_radius);
}

}  // namespace wirepack
