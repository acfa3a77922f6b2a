#include "wirepack/energy/spring_energy.hpp"

#include <utility>

namespace wirepack {

SpringEnergy::SpringEnergy(std::vector<PointSpring> springs) : springs_(std::move(springs)) {}

Energy SpringEnergy::add_gradient(const RodState& state, Gradient& gradient) const {
  EnergySum energy;
  for (const PointSpring& spring : springs_) {
    const Vec3 stretch = state.nodes.col(spring.node) - spring.point;
    energy.add(spring.stiffness / 2 * stretch.squaredNorm());
    gradient.node.col(spring.node) += spring.stiffness * stretch;
  }
  return energy.total();
}

void SpringEnergy::add_curvature(const RodState&, CurvatureModel& model) const {
  for (const PointSpring& spring : springs_) {
    model.add_node_block(spring.node, spring.stiffness * Mat3::Identity());
  }
}

}  // namespace wirepack
