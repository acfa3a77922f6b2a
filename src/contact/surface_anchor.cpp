#include "wirepack/contact/surface_anchor.hpp"

namespace wirepack {

namespace {

const Quat& frame_of(const RodState& state, Index edge) {
  return state.frames[static_cast<std::size_t>(edge)];
}

SurfaceAnchor anchored(const RodState& state, const RodParams& params, const SurfaceSlip& start) {
  SurfaceAnchor anchor;
  anchor.start = start;
  for (std::size_t k = 0; k < 2; ++k) {
    const SurfaceSlip::EdgePart& part = start.edges[k];
    anchor.body_levers[k] = frame_of(state, part.edge).conjugate() * part.lever;
    anchor.lengths[k] = rest_length(state, params, part.edge);
  }
  return anchor;
}

}  // namespace

SurfaceAnchor::Slip SurfaceAnchor::slip(const RodState& state, const RodParams& params) const {
  Slip now{Vec3::Zero(), start, Vec3::Zero()};
  Vec3 levers = Vec3::Zero();
  for (std::size_t k = 0; k < 2; ++k) {
    SurfaceSlip::EdgePart& part = now.map.edges[k];
    part.lever = frame_of(state, part.edge) * body_levers[k];
    levers += part.lever;
    if (on_wall) continue;
    // The edge's length from its first node to the point is a share of it that shrinks as it grows.
    const double length = rest_length(state, params, part.edge);
    if (length == lengths[k]) continue;
    SurfaceSlip::NodePart& from = now.map.nodes[2 * k];
    SurfaceSlip::NodePart& to = now.map.nodes[2 * k + 1];
    const double sum = from.weight + to.weight;
    to.weight *= lengths[k] / length;
    from.weight = sum - to.weight;
  }
  Vec3 offset = levers - origin;
  for (const SurfaceSlip::NodePart& part : now.map.nodes) {
    offset += part.weight * state.nodes.col(part.node);
  }
  if (!on_wall) {
    const double span = levers.norm();
    now.map.normal = -levers / span;
    // d|u|^2 / 2 = u.dW - (n.W) W.dn, and W.dn = -u.d(levers) / span
    const double share = 1 + now.map.normal.dot(offset) / span;
    for (SurfaceSlip::EdgePart& part : now.map.edges) part.lever *= share;
    const Index inlet = state.edge_count() - 1;
    for (std::size_t k = 0; k < 2; ++k) {
      if (now.map.edges[k].edge != inlet) continue;
      const Vec3 edge = state.nodes.col(next_node(state, inlet)) - state.nodes.col(inlet);
      now.by_inlet_length -= now.map.nodes[2 * k + 1].weight / state.inlet_rest_length * edge;
    }
  }
  now.u = now.map.tangential(offset);
  return now;
}

SurfaceAnchor strand_anchor(const RodState& state, const RodParams& params, Index first, double s,
                            Index second, double t, const Vec3& separation, const Vec3& spring) {
  // levers shortened by half the spring each: the points are off each other by all of it
  return anchored(state, params, strand_slip(state, first, s, second, t, separation - spring));
}

SurfaceAnchor wall_anchor(const RodState& state, const RodParams& params, const Cavity& cavity,
                          Index node, const Vec3& spring) {
  const SurfaceSlip start = wall_slip(state, node, params.radius, cavity);
  SurfaceAnchor anchor = anchored(state, params, start);
  anchor.on_wall = true;
  anchor.origin = state.nodes.col(node) + start.edges[0].lever + start.edges[1].lever - spring;
  return anchor;
}

}  // namespace wirepack
