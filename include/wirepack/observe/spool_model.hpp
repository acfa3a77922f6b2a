#pragma once

#include "wirepack/contact/cavity.hpp"

namespace wirepack {

/// Closed-form coil to compare a packing with: hexagonally stacked hoops that fill the sphere from
/// the wall inwards (inverse spool; Purohit, Kondev, Phillips 2003; Stoop et al. 2011, Eq. 2, with
/// the factor 4 pi / sqrt(3) of hexagonal hoops that its "~" hides). The outermost hoop has the
/// radius R of the cavity, where a wire's centreline has R - a.
///
/// All functions take a density phi in [0, largest_density()), else they throw InvalidInput.
struct SpoolModel {
  /// Spacing of strands over the wire radius that Stoop et al. 2011 read from cross-sections.
  static constexpr double seen_spacing = 2.81;

  Cavity cavity;
  double wire_radius;     ///< a
  double bend_stiffness;  ///< YI
  double spacing;         ///< d_s, distance of neighbouring strands; 2 a when they just touch

  /// phi of the full spool, 2 pi a^2 / (sqrt(3) d_s^2), where hoops reach the axis.
  double largest_density() const;
  /// E_b = (4 pi / sqrt 3) (R YI / d_s^2) (atanh x - x), x^2 = 1 - (inner radius / R)^2.
  double bend_energy(double density) const;
  /// dE_b / dL = YI / (2 inner_radius^2): the newest hoop is the innermost.
  double injection_force(double density) const;
  double inner_radius(double density) const;
};

}  // namespace wirepack
