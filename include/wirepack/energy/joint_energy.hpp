#pragma once

#include <string_view>

#include "wirepack/energy/energy_term.hpp"

namespace wirepack {

/// Bending and twist energy of one state, kept apart.
struct JointEnergies {
  double bend = 0, twist = 0;
};

/// Bending and twist of the joints: sum of [YI |k_12 - k_12^0|^2 + GJ (k_3 - k_3^0)^2] l / 2 with
/// the strains of rod_strain.hpp and l the node length (Stoop et al. 2011, Eq. 1, second and third
/// term, with GJ where the paper prints G). One term, because both strains come from the same
/// relative quaternion.
class JointEnergy {
 public:
  static constexpr std::string_view name = "joints";
  explicit JointEnergy(const RodParams& params) : JointEnergy(params, stiffness(params)) {}
  /// Takes other stiffnesses than those of the material. A twist stiffness of 0 stands for a wire
  /// whose torsion is known to vanish. If that is straight when stress-free, its energy is a
  /// function of the nodes and the clamps alone, and the edge frames are not read.
  JointEnergy(const RodParams& params, const Stiffness& stiffness);
  Energy add_gradient(const RodState& state, Gradient& gradient) const;
  void add_curvature(const RodState& state, CurvatureModel& model) const;

 private:
  /// True without torsion and rest curvature.
  bool of_tangents_alone() const;

  RodParams params_;
  Vec3 stiffness_;  // YI, YI, GJ
};

JointEnergies joint_energies(const RodParams& params, const RodState& state);

/// Energy of the joint at each node (N; zero where there is none), e.g. for colouring a wire.
struct NodeEnergies {
  Eigen::VectorXd bend, twist;
};
NodeEnergies node_energies(const RodParams& params, const RodState& state);

}  // namespace wirepack
