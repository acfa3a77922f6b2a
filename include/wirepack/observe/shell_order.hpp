#pragma once

#include <vector>

#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Nematic order of the tangents of the edges whose midpoints lie in a spherical shell.
struct ShellOrder {
  double inner, outer;  ///< radii [length]
  Index edges;
  double order;  ///< largest eigenvalue of <(3 t t - 1) / 2>; 0 without edges
};

/// Shells of this width from `cavity_radius` inwards, the outermost first, down to the centre.
std::vector<ShellOrder> order_by_shell(const RodState& state, double cavity_radius, double width);

}  // namespace wirepack
