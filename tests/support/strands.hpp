#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "wirepack/core/rotation.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack::testing {

/// Nodes of a straight strand: evenly spaced along `direction` (unit), `first` the first of them.
inline Points straight_strand(const Vec3& first, const Vec3& direction, double edge_length,
                              Index edges) {
  Points nodes(3, edges + 1);
  for (Index i = 0; i <= edges; ++i) {
    nodes.col(i) = first + static_cast<double>(i) * edge_length * direction;
  }
  return nodes;
}

/// The same, about its middle.
inline Points centred_strand(const Vec3& middle, const Vec3& direction, double edge_length,
                             Index edges) {
  const double half = static_cast<double>(edges) * edge_length / 2;
  return straight_strand(middle - half * direction, direction, edge_length, edges);
}

/// Nodes on a helix about z, from z = 0.
inline Points helix_strand(double radius, double pitch, double turns, Index edges) {
  Points nodes(3, edges + 1);
  for (Index i = 0; i <= edges; ++i) {
    const double turn = turns * static_cast<double>(i) / static_cast<double>(edges);
    nodes.col(i) =
        Vec3(radius * std::cos(2 * pi * turn), radius * std::sin(2 * pi * turn), pitch * turn);
  }
  return nodes;
}

/// Nodes of a closed regular polygon about z, its corners on the circle.
inline Points ring_nodes(double radius, Index edges, double height = 0, double first_angle = 0) {
  Points nodes(3, edges);
  for (Index i = 0; i < edges; ++i) {
    const double angle = first_angle + 2 * pi * static_cast<double>(i) / static_cast<double>(edges);
    nodes.col(i) = Vec3(radius * std::cos(angle), radius * std::sin(angle), height);
  }
  return nodes;
}

/// One wire with both strands as its legs, in the order given: from the first straight on by
/// `reach`, over a bridge `reach` above, and down into the second. Edges of the bridge are as long
/// as the first edge, as contact asks for.
struct TwoLegs {
  Points nodes;
  Index second;  ///< first node of the second leg
};
inline TwoLegs joined_strands(const Points& first, const Points& second, double reach = 12) {
  const Vec3 leave = (first.col(first.cols() - 1) - first.col(first.cols() - 2)).normalized();
  const Vec3 enter = (second.col(1) - second.col(0)).normalized();
  const Vec3 start = first.col(first.cols() - 1), end = second.col(0);
  const Vec3 up(0, 0, reach);
  const std::array<Vec3, 6> corners{start,
                                    start + reach * leave,
                                    start + reach * leave + up,
                                    end - reach * enter + up,
                                    end - reach * enter,
                                    end};
  const double edge_length = (first.col(1) - first.col(0)).norm();
  std::vector<Vec3> bridge;
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    const Vec3 side = corners[k + 1] - corners[k];
    const auto edges = static_cast<Index>(std::ceil(side.norm() / edge_length));
    for (Index i = k == 0 ? 1 : 0; i < edges; ++i) {
      bridge.emplace_back(corners[k] + static_cast<double>(i) / static_cast<double>(edges) * side);
    }
  }
  const auto joining = static_cast<Index>(bridge.size());
  TwoLegs legs{Points(3, first.cols() + joining + second.cols()), first.cols() + joining};
  legs.nodes.leftCols(first.cols()) = first;
  for (Index i = 0; i < joining; ++i) {
    legs.nodes.col(first.cols() + i) = bridge[static_cast<std::size_t>(i)];
  }
  legs.nodes.rightCols(second.cols()) = second;
  return legs;
}

}  // namespace wirepack::testing
