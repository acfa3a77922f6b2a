#include "wirepack/contact/surface_slip.hpp"

namespace wirepack {

SurfaceSlip strand_slip(const RodState& state, Index first, double s, Index second, double t,
                        const Vec3& separation) {
  SurfaceSlip slip;
  slip.normal = separation.normalized();
  slip.nodes = {{{first, 0.5 - s},
                 {next_node(state, first), 0.5 + s},
                 {second, t - 0.5},
                 {next_node(state, second), -t - 0.5}}};
  // -n h on the first strand, and on the second minus +n h
  slip.edges = {{{first, -separation / 2}, {second, -separation / 2}}};
  return slip;
}

SurfaceSlip wall_slip(const RodState& state, Index node, double wire_radius, const Cavity& cavity) {
  SurfaceSlip slip;
  slip.normal = -outward_normal(cavity, state.nodes.col(node));
  const Vec3 lever = -wire_radius * slip.normal;
  slip.nodes[0] = {node, 1.0};
  const bool closed = state.ends.closed;
  const Index before = node > 0 ? node - 1 : (closed ? state.edge_count() - 1 : 0);
  const Index after = node < state.edge_count() ? node : node - 1;
  slip.edges = {{{before, lever / 2}, {after, lever / 2}}};
  return slip;
}

}  // namespace wirepack
