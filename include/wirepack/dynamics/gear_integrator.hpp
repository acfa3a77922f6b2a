#pragma once

#include "wirepack/dynamics/dynamic_state.hpp"
#include "wirepack/dynamics/rates.hpp"

namespace wirepack {

/// Takes the state to the end of its step as far as it is known before forces are: the prediction
/// of nodes, spins and frames, the time, and the fed length.
void begin_step(DynamicState& state);
/// Corrects the prediction with the accelerations at it. `rod` stays at the prediction, which is
/// off by the order of the scheme; follow_nodes() brings it along.
void end_step(DynamicState& state, const Rates& rates);

/// One step of the predictor-corrector. `set_rates_of(state, rates)` is called once, at the
/// prediction, and fills the accelerations; `rates` is memory for them. Linear momentum is kept to
/// round-off, whatever the forces, as long as they add up to nothing.
template <class Acceleration>
void gear_step(DynamicState& state, Acceleration&& set_rates_of, Rates& rates) {
  begin_step(state);
  set_rates_of(static_cast<const DynamicState&>(state), rates);
  end_step(state, rates);
}

/// Sets the accelerations of a state that has just been made, which saves the scheme its start-up
/// error.
void start_accelerations(DynamicState& state, const Rates& rates);

}  // namespace wirepack
