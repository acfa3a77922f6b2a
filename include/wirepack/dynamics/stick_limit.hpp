#pragma once

#include "wirepack/dynamics/friction.hpp"

namespace wirepack {

/// Largest step of time over the period of a sticking contact, h omega, at which its force is
/// followed: 0.64 at small damping ratios zeta and 0.08 / zeta above 1/8 (the integrator's limits
/// for an oscillator, measured at zeta = 0, 0.05, 0.5 and 2).
double largest_stick_step(double damping_ratio);

/// The longest step of time at which the stick force of a law is followed. `stiffness_per_mass` is
/// that of the normal force [1 / time^2].
double longest_stick_step(const StickSlipLaw& law, double stiffness_per_mass);

/// Throws InvalidInput when the stick force of a law would chatter at this step: it would change
/// its sign from step to step, be taken for sliding, and hold nothing. `stiffness_per_mass` is that
/// of the normal force [1 / time^2].
void require_calm_sticking(const StickSlipLaw& law, double stiffness_per_mass, double step);

}  // namespace wirepack
