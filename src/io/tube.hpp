#pragma once

#include "wirepack/core/types.hpp"

namespace wirepack {

/// Points of the centreline with a value at each.
struct SmoothLine {
  Points points;
  Eigen::VectorXd colour;
};

/// The centreline through nodes (3 x N, N >= 2), `parts` points to an edge, on cubics with the mean
/// tangents at the nodes; `colour` (N) is interpolated linearly.
SmoothLine smooth_line(const Points& nodes, const Eigen::VectorXd& colour, Index parts);

/// Parts to an edge with which a wire of so many nodes looks round.
inline Index smooth_parts(Index nodes) { return nodes < 2000 ? 3 : 1; }

/// Rings of `around` points about each point of a line, one ring after the other, without twist
/// along the line. Ring k is the columns k * around, ...; its points run to the right about the
/// line.
Points tube_rings(const Points& line, double radius, Index around);

}  // namespace wirepack
