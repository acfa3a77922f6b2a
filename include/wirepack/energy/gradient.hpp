#pragma once

#include "wirepack/core/types.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Derivative of an energy by everything a state can vary.
struct Gradient {
  Points node;              ///< 3 x N: dE/dr [force]
  Points frame;             ///< 3 x frames: dE/d(spin), world axes [force length]
  double inlet_length = 0;  ///< explicit dE/d(inlet_rest_length): the injection force [force]
};

/// Zero gradient of the shape of `state`; reuses the memory of `gradient`.
void set_zero(Gradient& gradient, const RodState& state);

}  // namespace wirepack
