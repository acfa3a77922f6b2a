#pragma once

#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// The most wire that the limits on length, density and increments let a run insert; infinite when
/// none of them is set [length].
double longest_wire(const Scenario& scenario);

}  // namespace wirepack
