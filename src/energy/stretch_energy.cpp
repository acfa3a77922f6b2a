#include "wirepack/energy/stretch_energy.hpp"

#include <array>

namespace wirepack {

StretchEnergy::StretchEnergy(const RodParams& params)
    : params_(params), stiffness_(stiffness(params).stretch) {}

double StretchEnergy::add_gradient(const RodState& state, Gradient& gradient) const {
  double energy = 0;
  const Index edges = state.edge_count();
  for (Index j = 0; j < edges; ++j) {
    const Index next = next_node(state, j);
    const double rest = rest_length(state, params_, j);
    const Vec3 e = state.nodes.col(next) - state.nodes.col(j);
    const double length = e.norm();
    const double strain = length / rest - 1;
    energy += stiffness_ * rest / 2 * strain * strain;
    const Vec3 tension = (stiffness_ * strain / length) * e;
    gradient.node.col(next) += tension;
    gradient.node.col(j) -= tension;
    if (j == edges - 1 && !state.ends.closed) {
      gradient.inlet_length -= stiffness_ * strain * (1 + strain / 2);
    }
  }
  return energy;
}

void StretchEnergy::add_curvature(const RodState& state, CurvatureModel& model) const {
  for (Index j = 0; j < state.edge_count(); ++j) {
    const Index next = next_node(state, j);
    const Vec3 t = (state.nodes.col(next) - state.nodes.col(j)).normalized();
    const std::array<CurvatureModel::NodePart, 2> parts{{{next, t}, {j, -t}}};
    model.add_square(stiffness_ / rest_length(state, params_, j), parts);
  }
}

}  // namespace wirepack
