#include "wirepack/dynamics/rates.hpp"

#include "wirepack/core/rotation.hpp"

namespace wirepack {

void set_rates(const DynamicState& state, const WireMotion& motion, const Inertia& inertia,
               const Gradient& gradient, Rates& rates) {
  const RodState& rod = state.rod;
  const Index edges = rod.edge_count();
  rates.node = -gradient.node.reshaped();
  rates.spin.resize(inertia.spin.size());
  for (Index j = 0; j < edges; ++j) {
    const Vec3 t = motion.tangent.col(j);
    const Vec3 moment = -gradient.frame.col(j);
    const double spin = state.spin_rate(j);
    // t x t' is the part of the angular velocity across the tangent
    const Vec3 turning = motion.angular_velocity.col(j) - spin * t;
    const Vec3 couple = (moment.cross(t) + inertia.spin[j] * spin * turning) / motion.length[j];
    rates.node.segment<3>(3 * next_node(rod, j)) += couple;
    rates.node.segment<3>(3 * j) -= couple;
    rates.spin[j] = moment.dot(t);
  }
  for (Index k = edges; k < rates.spin.size(); ++k) {
    rates.spin[k] = -gradient.frame.col(k).dot(third_axis(rod.frames[static_cast<std::size_t>(k)]));
  }
  rates.node = rates.node.cwiseProduct(inertia.inverse_mass);
  rates.spin = rates.spin.cwiseProduct(inertia.inverse_spin);
}

}  // namespace wirepack
