#pragma once

#include "wirepack/core/types.hpp"
#include "wirepack/rod/rod_params.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Integrated strain of a joint, see joint_strain.hpp.
Vec3 joint_strain(const Quat& before, const Quat& after, double twist_guide);

/// The strain with its derivative by the relative spin of the two frames:
/// d(value) = by_spin R_before^T (spin_after - spin_before), spins in world axes.
struct JointStrain {
  Vec3 value;
  Mat3 by_spin;
};
JointStrain joint_strain_derivative(const Quat& before, const Quat& after, double twist_guide);

/// Strain |e| / l - 1 of an edge.
double edge_strain(const RodState& state, const RodParams& params, Index edge);

/// Twist of each node's joint as it is now; becomes the next twist_guide of an accepted state.
std::vector<double> joint_twists(const RodState& state);

}  // namespace wirepack
