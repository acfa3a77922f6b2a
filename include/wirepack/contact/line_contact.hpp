#pragma once

#include <optional>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// A straight edge of a strand: its midpoint and its vector; points m + s e, |s| <= 1/2.
struct Line {
  Vec3 midpoint, vector;
  bool ends_before = false;  ///< the strand has a free end at s = -1/2
  bool ends_after = false;   ///< the strand has a free end at s = +1/2
};

/// Two strands meeting near a pair of their edges. Near means nearest points of the two lines,
/// regularised so that parallel lines have one solution; every pair of neighbouring edges sees the
/// same meeting, and quadratic B-spline weights in the parameters share it out among them without
/// bumps as strands slide along each other.
struct LineContact {
  double s, t;      ///< parameters of the meeting on both lines
  double weight;    ///< product of the two B-splines, 0 .. 9/16
  Vec3 separation;  ///< point on the first line minus point on the second
  double distance;  ///< |separation|
};

/// Derivative of a line contact's energy by both lines.
struct LineGradient {
  Vec3 midpoint1, vector1, midpoint2, vector2;
};

/// The kernel: distances below `touching_distance` cost stiffness / 2 weight overlap^2.
struct LineKernel {
  double touching_distance;  ///< 2 a
  double edge_length;        ///< l; scales the regularisation
  double stiffness;          ///< per pair of edges [force / length]

  /// Weight of all pairs of edges, summed, per edge of two parallel strands: a stiffness per length
  /// k' is k' l / parallel_weight per pair.
  static constexpr double regularisation = 0.1;
  static constexpr double parallel_weight = (2 + regularisation) * 11 / 20;

  /// The touch of two lines; nothing when they are apart or meet outside the support of the pair.
  std::optional<LineContact> touch(const Line& first, const Line& second) const;
  /// Energy of the pair; sets its exact gradient when they touch (else leaves it alone).
  double energy(const Line& first, const Line& second, LineGradient& gradient) const;
};

}  // namespace wirepack
