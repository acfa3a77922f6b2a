#pragma once

#include "wirepack/core/types.hpp"
#include "wirepack/rod/rod_params.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Integrated strain of a joint: bending (k1, k2) l and twist k3 l, dimensionless.
///
/// The relative quaternion p = conj(q_before) q_after = (w, x, y, z) is a turn of the tangent
/// between two halves of a twist; bending is 2 (x, y) / sqrt(w^2 + z^2), of length 2 tan(angle / 2),
/// in the frame half-way through the twist, and twist is 2 atan2(z, w). Bending is thus independent
/// of the relative twist (averaged directors of the two edges are not, and open a hinge), and it
/// grows without bound towards a turn of pi.
///
/// `twist_guide` picks the whole turns: the twist returned is within pi of it.
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
