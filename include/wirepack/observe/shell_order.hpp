#pragma once

#include <vector>

#include "wirepack/contact/cavity.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Nematic order of the tangents of the edges whose midpoints lie in a shell along the wall.
struct ShellOrder {
  double inner, outer;  ///< radii; of an ellipsoid its shortest semi-axis less the depth [length]
  Index edges;
  double order;  ///< largest eigenvalue of <(3 t t - 1) / 2>; 0 without edges
};

/// Shells of this width from the wall inwards, the outermost first, down to the centre.
std::vector<ShellOrder> order_by_shell(const RodState& state, const Cavity& cavity, double width);

}  // namespace wirepack
