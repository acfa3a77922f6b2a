#include "wirepack/dynamics/damping.hpp"

namespace wirepack {

DampingPower add_damping(double rate, const DynamicState& state, const WireMotion& motion,
                         const Inertia& inertia, Rates& rates) {
  DampingPower power;
  const Index n = inertia.mass.size();
  const Index edges = motion.edge.cols();
  const bool closed = state.rod.ends.closed;
  for (Index i = 0; i < n; ++i) {
    const Vec3 free = (inertia.inverse_mass.segment<3>(3 * i).array() != 0).cast<double>();
    Vec3 flow = Vec3::Zero();
    if (state.feed_speed != 0) {
      const Index before = i > 0 ? i - 1 : (closed ? edges - 1 : 0);
      const Index after = i < edges ? i : edges - 1;
      flow = -state.feed_speed / 2 * (motion.tangent.col(before) + motion.tangent.col(after));
    }
    const Vec3 relative = (motion.velocity.col(i) - flow).cwiseProduct(free);
    rates.node.segment<3>(3 * i) -= rate * relative;
    power.dissipated += rate * inertia.mass[i] * relative.squaredNorm();
    power.carried -= rate * inertia.mass[i] * relative.dot(flow);
  }
  for (Index j = 0; j < inertia.spin.size(); ++j) {
    if (inertia.inverse_spin[j] == 0) continue;
    const double spin = state.spin_rate(j);
    rates.spin[j] -= rate * spin;
    power.dissipated += rate * inertia.spin[j] * spin * spin;
  }
  return power;
}

}  // namespace wirepack
