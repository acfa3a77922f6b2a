#include "wirepack/energy/reactions.hpp"

namespace wirepack {

Points reactions(const RodState& state, const Gradient& gradient) {
  Points force = gradient.node;
  for (Index j = 0; j < state.edge_count(); ++j) {
    const Index next = next_node(state, j);
    const Vec3 edge = state.nodes.col(next) - state.nodes.col(j);
    // moving the end by d turns the edge by t x d / |e|
    const Vec3 by_end = gradient.frame.col(j).cross(edge) / edge.squaredNorm();
    force.col(next) += by_end;
    force.col(j) -= by_end;
  }
  return force;
}

}  // namespace wirepack
