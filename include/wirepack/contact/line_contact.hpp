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

/// Two strands meeting near a pair of their edges: the nearest points of the two lines. Every pair
/// of neighbouring edges sees the same meeting, and quadratic B-spline weights in the parameters
/// share it out among them without bumps as strands slide along each other.
///
/// Lines that are nearly parallel meet far away or nowhere: there the common motion of both points
/// along the lines is held back, by eta |s e1 + t e2|^2 with eta = (a / 2 l) cos^8(angle). Strands
/// that close in on each other at a small angle then shift the meeting by angle edges only, for any
/// mesh. (Holding both points back by a constant instead shifts it by 5 angle 2a / l: the weights
/// run out on fine meshes and the strands leak through each other.)
struct LineContact {
  double s, t;       ///< parameters of the meeting on both lines
  double stiffness;  ///< of this pair, its weight included: energy stiffness / 2 overlap^2
  Vec3 separation;   ///< point on the first line minus point on the second
  double distance;   ///< |separation|
};

/// Derivative of a line contact's energy by both lines.
struct LineGradient {
  Vec3 midpoint1, vector1, midpoint2, vector2;
};

/// The kernel: a pair at a distance below `touching_distance` costs k W / 2 overlap^2, W the
/// product of its two weights, and k between its values for parallel lines and for a right angle:
/// parallel strands have a stiffness per length, a crossing has one of its own, neither depends on
/// the mesh.
struct LineKernel {
  double touching_distance;   ///< 2 a
  double edge_length;         ///< l
  double parallel_stiffness;  ///< of a pair of parallel edges [force / length]
  double crossing_stiffness;  ///< of a crossing at a right angle [force / length]

  /// The kernel for a stiffness k' per length of parallel strands [force / length^2]. A crossing
  /// counts as a length 2 a of them.
  static LineKernel per_length(double stiffness, double wire_radius, double edge_length);

  /// Weights of all pairs of edges, summed, per edge of two parallel strands; for a crossing at a
  /// right angle they sum to 1.
  static constexpr double parallel_weight = 2.0 * 11 / 20;
  /// k for lines whose angle has this cos^8.
  template <class T>
  T pair_stiffness(const T& parallel) const {
    return crossing_stiffness + (parallel_stiffness - crossing_stiffness) * parallel;
  }
  /// eta of parallel lines.
  double parallel_hold() const { return touching_distance / (4 * edge_length); }

  /// The touch of two lines; nothing when they are apart or meet outside the support of the pair.
  std::optional<LineContact> touch(const Line& first, const Line& second) const;
  /// Second derivative of the energy of a pair that touches and has no free end, by the vector
  /// between the midpoints (second to first) and both edge vectors.
  Eigen::Matrix<double, 9, 9> second_derivative(const Line& first, const Line& second) const;
  /// Energy of the pair; sets its exact gradient when they touch (else leaves it alone).
  double energy(const Line& first, const Line& second, LineGradient& gradient) const;
};

}  // namespace wirepack
