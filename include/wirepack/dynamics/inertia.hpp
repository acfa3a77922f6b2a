#pragma once

#include "wirepack/core/types.hpp"
#include "wirepack/dynamics/dynamic_state.hpp"
#include "wirepack/rod/frame_chart.hpp"
#include "wirepack/rod/rod_params.hpp"

namespace wirepack {

/// Masses and spin inertias of a wire of density rho, lumped: a node has rho pi a^2 times its node
/// length, the frame of an edge rho pi a^4 / 2 times the rest length of the edge about its tangent,
/// and the frame of a clamp that of half an edge of wire in the nozzle.
///
/// Rotary inertia of the cross-section about transverse axes is left out (it is smaller than that
/// of the lumped masses by a^2 k^2 / 4 for waves of wave number k).
struct Inertia {
  double density;                ///< rho [mass / length^3]
  Eigen::VectorXd mass;          ///< N
  Eigen::VectorXd spin;          ///< one per frame
  Eigen::VectorXd inverse_mass;  ///< 3N; 0 for a held coordinate
  Eigen::VectorXd inverse_spin;  ///< one per frame; 0 for a held angle

  double mass_per_length(const RodParams& params) const {
    return density * pi * params.radius * params.radius;
  }
};
Inertia lumped_inertia(const RodState& rod, const RodParams& params, double density,
                       const HeldUnknowns& held);
/// Follows the growth of the inlet edge, the only part that changes.
void update_inlet(Inertia& inertia, const RodState& rod, const RodParams& params);

double kinetic_energy(const DynamicState& state, const Inertia& inertia);
Vec3 linear_momentum(const DynamicState& state, const Inertia& inertia);
/// About the origin, with the angular momentum of the spins, I spin_rate t.
Vec3 angular_momentum(const DynamicState& state, const Inertia& inertia);

}  // namespace wirepack
