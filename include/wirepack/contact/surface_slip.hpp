#pragma once

#include <array>

#include "wirepack/contact/cavity.hpp"
#include "wirepack/core/types.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Slip of two touching surfaces: u = P (sum w_i dr_i + sum dphi_j x c_j), P = 1 - n n^T.
/// dr_i moves a node. dphi_j rotates an edge, twist included: dphi = dtheta t + t x dt in world
/// axes. n is the normal. c_j is the lever from the centreline of the edge to the surfaces' common
/// point, with the sign that makes u first minus second surface. Displacements give the slip,
/// velocities and angular velocities its rate. Exact for rigid motions: they give none.
struct SurfaceSlip {
  struct NodePart {
    Index node = 0;
    double weight = 0;
  };
  struct EdgePart {
    Index edge = 0;
    Vec3 lever = Vec3::Zero();
  };
  std::array<NodePart, 4> nodes{};
  std::array<EdgePart, 2> edges{};
  Vec3 normal = Vec3::UnitZ();

  Vec3 tangential(const Vec3& v) const { return v - normal.dot(v) * normal; }

  /// Slip u of these motions of all nodes (3 x N) and edges (3 x edges or more).
  Vec3 of(const Points& by_node, const Points& by_edge) const {
    Vec3 u = Vec3::Zero();
    for (const NodePart& part : nodes) u += part.weight * by_node.col(part.node);
    for (const EdgePart& part : edges) u += by_edge.col(part.edge).cross(part.lever);
    return tangential(u);
  }

  /// Transpose of the slip: adds the forces on nodes and moments on edges that the tangential force
  /// f on the first surface and -f on the second exert. Those of two strands add up to no force and
  /// no moment.
  void add_force(const Vec3& f, Points& node_force, Points& edge_moment) const {
    for (const NodePart& part : nodes) node_force.col(part.node) += part.weight * f;
    for (const EdgePart& part : edges) edge_moment.col(part.edge) += part.lever.cross(f);
  }
};

/// Slip of two strands that touch at parameters s and t of their edges (points m + s e, |s| <= 1/2
/// inside). `separation` is first minus second point; the surfaces meet half-way between them.
SurfaceSlip strand_slip(const RodState& state, Index first, double s, Index second, double t,
                        const Vec3& separation);

/// Slip of the wire's surface against the wall, at a node. The two edges that meet there have half
/// of the lever each.
SurfaceSlip wall_slip(const RodState& state, Index node, double wire_radius, const Cavity& cavity);

}  // namespace wirepack
