#pragma once

#include "wirepack/dynamics/inertia.hpp"
#include "wirepack/dynamics/rates.hpp"

namespace wirepack {

/// Power of the viscous forces [energy / time].
struct DampingPower {
  double dissipated = 0;  ///< >= 0
  double carried = 0;     ///< work of the medium that moves with the fed wire; either sign
};

/// Small viscous damping at a rate g [1 / time]: a node of mass m feels -g m (v - w), a spin of
/// inertia I the moment -g I spin_rate. An oscillation decays as exp(-g t / 2), a falling wire ends
/// at gravity / g; per length of wire the coefficient is g rho pi a^2.
///
/// w is the motion of a wire that is fed along itself at feed_speed: -feed_speed times the tangent,
/// 0 where nothing is fed. All of a packed wire slides along its own line while it is fed, so a
/// drag against the cavity's frame would add g rho pi a^2 L feed_speed to the injection force
/// (several times the force itself in long runs); this one damps what departs from that motion.
///
/// Adds to the rates; held coordinates are left alone.
DampingPower add_damping(double rate, const DynamicState& state, const WireMotion& motion,
                         const Inertia& inertia, Rates& rates);

}  // namespace wirepack
