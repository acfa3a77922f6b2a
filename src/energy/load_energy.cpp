#include "wirepack/energy/load_energy.hpp"

#include <cmath>
#include <utility>

#include "wirepack/core/rotation.hpp"

namespace wirepack {

double EdgeMoment::angle(const RodState& state) const {
  const Quat turn = state.frames[static_cast<std::size_t>(edge)] * reference.conjugate();
  return nearest_turn(2 * std::atan2(turn.vec().dot(axis), turn.w()), angle_guide);
}

LoadEnergy::LoadEnergy(const RodParams& params, Loads loads)
    : params_(params), loads_(std::move(loads)) {}

Energy LoadEnergy::add_gradient(const RodState& state, Gradient& gradient) const {
  EnergySum energy;
  for (const NodeForce& load : loads_.forces) {
    energy.add(-load.force.dot(state.nodes.col(load.node)));
    gradient.node.col(load.node) -= load.force;
  }
  for (const EdgeMoment& load : loads_.moments) {
    energy.add(-load.moment * load.angle(state));
    const Quat turn =
        state.frames[static_cast<std::size_t>(load.edge)] * load.reference.conjugate();
    // angle = 2 atan2(v.n, w), d(w, v) = 1/2 (-spin.v, w spin + spin x v)
    const Vec3 v = turn.vec();
    const double vn = v.dot(load.axis);
    const double w = turn.w();
    const Vec3 by_spin = (w * (w * load.axis + v.cross(load.axis)) + vn * v) / (vn * vn + w * w);
    gradient.frame.col(load.edge) -= load.moment * by_spin;
  }
  if (!loads_.weight.isZero()) {
    for (Index i = 0; i < state.node_count(); ++i) {
      const double length = node_length(state, params_, i);
      const double work = loads_.weight.dot(state.nodes.col(i));
      energy.add(-length * work);
      gradient.node.col(i) -= length * loads_.weight;
      gradient.inlet_length -= node_length_by_inlet(state, i) * work;
    }
  }
  return energy.total();
}

}  // namespace wirepack
