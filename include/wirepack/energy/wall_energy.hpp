#pragma once

#include <string_view>

#include "wirepack/contact/cavity.hpp"
#include "wirepack/energy/energy_term.hpp"

namespace wirepack {

/// Linear repulsion from the wall: sum over nodes of k l / 2 overlap^2, l the node length, so that
/// k is a force per length of wire and per overlap [force / length^2] and results do not depend on
/// the mesh.
class WallEnergy {
 public:
  static constexpr std::string_view name = "wall";
  WallEnergy(const RodParams& params, const SphericalCavity& cavity, double stiffness);
  Energy add_gradient(const RodState& state, Gradient& gradient) const;
  void add_curvature(const RodState& state, CurvatureModel& model) const;
  /// Force of the wall on each node (N), >= 0.
  Eigen::VectorXd forces(const RodState& state) const;

 private:
  RodParams params_;
  SphericalCavity cavity_;
  double stiffness_;
};

}  // namespace wirepack
