#include "wirepack/energy/wall_energy.hpp"

#include <algorithm>
#include <cmath>

#include "wirepack/core/lanes.hpp"

namespace wirepack {

WallEnergy::WallEnergy(const RodParams& params, const SphericalCavity& cavity, double stiffness)
    : params_(params), cavity_(cavity), stiffness_(stiffness) {}

Energy WallEnergy::add_gradient(const RodState& state, Gradient& gradient) const {
  EnergySum energy;
  const auto add = [&]<class T>(Index i, double length) {
    using std::sqrt;
    const Triple<T> r = load_columns<T>(state.nodes, i);
    const T overlap = -wall_gap(cavity_, r, params_.radius);
    const auto touches = overlap > 0.0;
    const T per_length = select(touches, 0.5 * stiffness_ * overlap * overlap, T(0.0));
    const T pull = length * stiffness_ * overlap / sqrt(dot(r, r));
    energy.add(T(length * per_length));
    store_columns(load_columns<T>(gradient.node, i) + select(touches, pull, T(0.0)) * r,
                  gradient.node, i);
    return per_length;
  };
  const auto add_end = [&](Index i) {
    const double per_length = add.operator()<double>(i, node_length(state, params_, i));
    gradient.inlet_length += node_length_by_inlet(state, i) * per_length;
  };
  const Index last = state.node_count() - 1;
  add_end(0);
  for_each_in_lanes(1, last - 1,
                    [&]<class T>(Index i) { add.template operator()<T>(i, params_.edge_length); });
  for (Index i = std::max<Index>(1, last - 1); i <= last; ++i) add_end(i);
  return energy.total();
}

void WallEnergy::add_curvature(const RodState& state, CurvatureModel& model) const {
  for (Index i = 0; i < state.node_count(); ++i) {
    const Vec3 r = state.nodes.col(i);
    const double overlap = -wall_gap(cavity_, r, params_.radius);
    if (overlap <= -nearly_touching * params_.radius) continue;
    const double distance = r.norm();
    const Vec3 n = r / distance;
    const double k = node_length(state, params_, i) * stiffness_;
    // exact Hessian: the normal part, and the wall's own curvature times the force
    const double turning = std::max(0.0, overlap) / distance;
    model.add_node_block(
        i, k * (n * n.transpose() + turning * (Mat3::Identity() - n * n.transpose())));
  }
}

Eigen::VectorXd WallEnergy::forces(const RodState& state) const {
  Eigen::VectorXd result(state.node_count());
  for (Index i = 0; i < state.node_count(); ++i) {
    const double overlap = -wall_gap(cavity_, state.nodes.col(i), params_.radius);
    result[i] = node_length(state, params_, i) * stiffness_ * std::max(0.0, overlap);
  }
  return result;
}

}  // namespace wirepack
