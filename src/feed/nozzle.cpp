#include "wirepack/feed/nozzle.hpp"

namespace wirepack {

Nozzle polar_nozzle(const SphericalCavity& cavity, double wire_radius, TwistCondition twist) {
  return {Vec3(0, 0, cavity.radius - wire_radius), Vec3::UnitZ(), twist};
}

HeldUnknowns held_by(const Nozzle& nozzle, const RodState& state) {
  HeldUnknowns held = HeldUnknowns::none(state);
  held.hold_node(state.node_count() - 1);
  if (nozzle.twist == TwistCondition::locked) {
    held.angle[static_cast<std::size_t>(state.last_clamp_frame())] = true;
  }
  return held;
}

RodState initial_wire(const Nozzle& nozzle, const RodParams& params) {
  Points nodes(3, 3);
  for (Index i = 0; i < 3; ++i) {
    nodes.col(i) =
        nozzle.position - static_cast<double>(2 - i) * params.edge_length * nozzle.direction;
  }
  return make_rod(nodes, params, RodEnds{.last_clamped = true});
}

}  // namespace wirepack
