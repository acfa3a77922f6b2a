#pragma once

#include "wirepack/dynamics/friction.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// Values of [dynamics], given or chosen by the program.
struct DynamicsValues {
  double damping;  ///< g; c a / (4 R^2) by default, with the speed of sound c = sqrt(Y / rho)
  double insertion_speed;  ///< c a / (40 R) by default: R / 40 while a bending wave crosses the
                           ///< cavity, which takes about R^2 / (c a)
  /// By default 0.2 over the highest frequency, and 0.4 of the longest step that follows a contact
  /// that sticks.
  double time_step;
  double highest_frequency;  ///< an upper estimate for the modes of a packed wire
};
DynamicsValues dynamics_values(const Scenario& scenario);

/// The law of friction of a scenario: tangential springs of two thirds of the normal stiffness
/// (that of a round, smooth contact is between this and one: Mindlin 1949), damped by a twentieth
/// of the critical value.
StickSlipLaw stick_slip_law(const Scenario& scenario);

/// The longest time step that is accepted.
double longest_time_step(const Scenario& scenario);

}  // namespace wirepack
