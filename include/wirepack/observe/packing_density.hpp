#pragma once

#include "wirepack/contact/cavity.hpp"

namespace wirepack {

/// Part of the cavity's volume that wire of this length fills: phi = L pi a^2 / (4/3 pi R^3)
/// = 3 a^2 L / (4 R^3).
inline double packing_density(double length, const Cavity& cavity, double wire_radius) {
  const double r = cavity.radius;
  return 3 * wire_radius * wire_radius * length / (4 * r * r * r);
}

/// Length of wire that fills the cavity to this density.
inline double length_at_density(double density, const Cavity& cavity, double wire_radius) {
  const double r = cavity.radius;
  return 4 * r * r * r * density / (3 * wire_radius * wire_radius);
}

}  // namespace wirepack
