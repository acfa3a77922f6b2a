#include "wirepack/energy/wall_energy.hpp"

#include <algorithm>

namespace wirepack {

WallEnergy::WallEnergy(const RodParams& params, const SphericalCavity& cavity, double stiffness)
    : params_(params), cavity_(cavity), stiffness_(stiffness) {}

double WallEnergy::add_gradient(const RodState& state, Gradient& gradient) const {
  double energy = 0;
  for (Index i = 0; i < state.node_count(); ++i) {
    const Vec3 r = state.nodes.col(i);
    const double overlap = -wall_gap(cavity_, r, params_.radius);
    if (overlap <= 0) continue;
    const double length = node_length(state, params_, i);
    const double per_length = stiffness_ / 2 * overlap * overlap;
    energy += length * per_length;
    gradient.node.col(i) += (length * stiffness_ * overlap / r.norm()) * r;
    gradient.inlet_length += node_length_by_inlet(state, i) * per_length;
  }
  return energy;
}

void WallEnergy::add_curvature(const RodState& state, CurvatureModel& model) const {
  for (Index i = 0; i < state.node_count(); ++i) {
    const Vec3 r = state.nodes.col(i);
    const double overlap = -wall_gap(cavity_, r, params_.radius);
    if (overlap <= 0) continue;
    const double distance = r.norm();
    const Vec3 n = r / distance;
    const double k = node_length(state, params_, i) * stiffness_;
    // exact Hessian: the normal part, and the wall's own curvature times the force
    model.add_node_block(
        i, k * (n * n.transpose() + overlap / distance * (Mat3::Identity() - n * n.transpose())));
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
