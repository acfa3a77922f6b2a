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

/// Meeting of two strands near a pair of their edges: the nearest points of the two lines. Every
/// pair of neighbouring edges sees the same meeting. Quadratic B-spline weights in the parameters
/// share it out among them without bumps as strands slide along each other.
///
/// Lines that are nearly parallel meet far away or nowhere. There a penalty eta |s e1 + t e2|^2,
/// eta = (a / 2 l) cos^8(angle), holds back the common motion of both points along the lines.
/// Strands that close in on each other at a small angle then shift the meeting by angle edges only,
/// on any mesh. (A constant that holds back both points shifts it by 5 angle 2a / l instead: the
/// weights run out on fine meshes, and strands leak through each other.)
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

/// Contact kernel: a pair nearer than `touching_distance` costs k W / 2 overlap^2. W is the product
/// of its two weights, k lies between its values for parallel lines and for a right angle. Parallel
/// strands have a stiffness per length, a crossing has one of its own. Neither depends on the mesh;
/// crossings between 60 degrees and parallel do (method.md).
struct LineKernel {
  double touching_distance;   ///< 2 a
  double edge_length;         ///< l
  double parallel_stiffness;  ///< of a pair of parallel edges [force / length]
  double crossing_stiffness;  ///< of a crossing at a right angle [force / length]

  /// The kernel for a stiffness k' per length of parallel strands [force / length^2]. A crossing
  /// counts as a length 2 a of them.
  static LineKernel per_length(double stiffness, double wire_radius, double edge_length);

  /// Mean sum of the weights of all pairs, per edge of two parallel strands. Those of a crossing at
  /// a right angle sum to 1.
  static constexpr double parallel_weight = 2.0 * 11 / 20;
  /// k for lines whose angle has this cos^8.
  template <class T>
  T pair_stiffness(const T& parallel) const {
    return crossing_stiffness + (parallel_stiffness - crossing_stiffness) * parallel;
  }
  /// eta of parallel lines.
  double parallel_hold() const { return touching_distance / (4 * edge_length); }

  /// Contact of two lines; nothing if they are apart, or meet outside the support of the pair.
  std::optional<LineContact> touch(const Line& first, const Line& second) const;
  /// Second derivative of the energy of a pair that touches and has no free end, by the vector
  /// between the midpoints (second to first) and both edge vectors.
  Eigen::Matrix<double, 9, 9> second_derivative(const Line& first, const Line& second) const;
  /// Energy of the pair; sets its exact gradient when they touch (else leaves it alone).
  double energy(const Line& first, const Line& second, LineGradient& gradient) const;
};

}  // namespace wirepack
