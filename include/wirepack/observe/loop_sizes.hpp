#pragma once

#include <vector>

#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Curvature angle / l at every inner node, l the mean length of its two edges [1 / length]: that
/// of an arc as long. On the nodes of a polygon inscribed in a circle it is that of the circle but
/// for a share (l / r)^2 / 24.
std::vector<double> local_curvatures(const RodState& state);

/// Lengths of successive stretches along which the wire turns by 2 pi, from the tip on; 2 pi r on a
/// circle of radius r. What is left at the end is no loop. Open rods only.
std::vector<double> loop_lengths(const RodState& state);

}  // namespace wirepack
