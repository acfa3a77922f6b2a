#include "wirepack/feed/nozzle.hpp"

namespace wirepack {

Nozzle nozzle_at_wall(const NozzleOptions& options, const Cavity& cavity, double wire_radius) {
  Nozzle nozzle{Vec3(0, 0, semi_axes_of(cavity).z() - wire_radius), Vec3::UnitZ(), options.twist};
  if (options.position) {
    nozzle.position = *options.position;
    nozzle.direction = outward_normal(cavity, nozzle.position);
  }
  if (options.direction) nozzle.direction = -options.direction->stableNormalized();
  return nozzle;
}

HeldUnknowns held_by(const Nozzle& nozzle, const RodState& state) {
  HeldUnknowns held = HeldUnknowns::none(state);
  held.hold_node(state.node_count() - 1);
  if (nozzle.twist == TwistCondition::locked) {
    held.angle[static_cast<std::size_t>(state.last_clamp_frame())] = true;
  }
  return held;
}

RodState initial_wire(const Nozzle& nozzle, const RodParams& params, double inlet_rest_length) {
  Points nodes(3, 3);
  nodes.col(2) = nozzle.position;
  nodes.col(1) = nodes.col(2) - inlet_rest_length * nozzle.direction;
  nodes.col(0) = nodes.col(1) - params.edge_length * nozzle.direction;
  RodState wire = make_rod(nodes, params, RodEnds{.last_clamped = true});
  wire.inlet_rest_length = inlet_rest_length;
  return wire;
}

}  // namespace wirepack
