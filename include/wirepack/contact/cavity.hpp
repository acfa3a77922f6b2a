#pragma once

#include <optional>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// Rigid cavity about the origin: a sphere, or an ellipsoid whose axes are x, y and z.
struct Cavity {
  double radius = 10;  ///< R; of an ellipsoid that of the sphere of its volume [length]
  std::optional<Vec3> semi_axes = std::nullopt;  ///< of an ellipsoid [length]
};

/// An ellipsoid with these semi-axes; impossible ones are refused by problems(Scenario).
Cavity ellipsoid(const Vec3& semi_axes);

/// Semi-axes along x, y and z; of a sphere R each.
Vec3 semi_axes_of(const Cavity& cavity);

/// Smallest radius of curvature that the wall has anywhere.
double smallest_wall_radius(const Cavity& cavity);

/// Distance between the surface of a wire of this radius and the wall at a centreline point;
/// negative where they overlap. Of points farther from an ellipsoid's wall than that bends it is
/// above zero, and an estimate.
double wall_gap(const Cavity& cavity, const Vec3& point, double wire_radius);

/// Unit normal of the wall at its point nearest to this one, out of the cavity.
Vec3 outward_normal(const Cavity& cavity, const Vec3& point);

/// Hessian of stiffness / 2 overlap^2 at a point, overlap = -wall_gap:
/// stiffness (n n^T + overlap dn/dr). The second part is the wall's own curvature.
Mat3 contact_hessian(const Cavity& cavity, const Vec3& point, double overlap, double stiffness);

/// The point on the ray from the origin through `inside` at which a wire of this radius touches the
/// wall.
Vec3 touching_point(const Cavity& cavity, const Vec3& inside, double wire_radius);

}  // namespace wirepack
