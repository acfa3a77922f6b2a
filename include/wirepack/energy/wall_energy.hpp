#pragma once

#include <string_view>

#include "wirepack/contact/cavity.hpp"
#include "wirepack/energy/energy_term.hpp"

namespace wirepack {

/// Linear repulsion from the wall: sum over nodes of k l / 2 overlap^2, l the length of wire that
/// the contact stands for. k is a force per length of wire and per overlap [force / length^2].
///
/// An inner node has its node length as l, so that results do not depend on the mesh. A free end
/// that stands on the wall touches it at a point: l = 2 a on any mesh, as at a crossing of strands.
/// An end that lies along the wall has l = half an edge. In general,
/// l = half an edge + (2 a - half an edge) (t.n)^2, t the tangent of the end's edge and n the
/// normal of the wall.
class WallEnergy {
 public:
  static constexpr std::string_view name = "wall";
  WallEnergy(const RodParams& params, const Cavity& cavity, double stiffness);
  Energy add_gradient(const RodState& state, Gradient& gradient) const;
  void add_curvature(const RodState& state, CurvatureModel& model) const;
  /// Force per overlap of each node [force / length].
  double stiffness(const RodState& state, Index node) const;
  /// Force of the wall on each node (N), >= 0.
  Eigen::VectorXd forces(const RodState& state) const;

 private:
  template <class Shape>
  Energy add_gradient(const Shape& shape, const RodState& state, Gradient& gradient) const;

  RodParams params_;
  Cavity cavity_;
  double stiffness_;
};

}  // namespace wirepack
