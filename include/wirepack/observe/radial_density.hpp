#pragma once

#include <vector>

#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Part of a spherical shell that is wire.
struct ShellDensity {
  double inner, outer;  ///< radii [length]
  double density;       ///< wire volume over shell volume
};

/// Volume of the wire within each of these distances from the origin (ascending). The wire is a
/// tube: discs of its radius across the straight edges, each cut exactly by the ball (the lens of
/// two circles), with the volume (1 - kappa.x) dA ds of a bent tube at the place x of the disc.
/// Along an edge, Gauss quadrature with four points. A cut grows or shrinks along each half of an
/// edge, so one edge is wrong by less than its volume where a ball cuts it, and not at all
/// elsewhere; on rings the error falls with the square of the edge length (1.5e-3 of the volume at
/// edges of a/2 and a radius of 10 a).
std::vector<double> volume_within(const RodState& state, double wire_radius,
                                  const std::vector<double>& radii);

/// The profile in `count` shells of equal width from the centre to `cavity_radius`.
std::vector<ShellDensity> radial_density(const RodState& state, double wire_radius,
                                         double cavity_radius, Index count);

}  // namespace wirepack
