#pragma once

#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// The most wire that the limits on length, density and increments let a run insert; infinite when
/// none of them is set [length].
double longest_wire(const Scenario& scenario);

/// Length at which the run is expected to end: by the limits on length, density and increments, or
/// else by the law phi_max = 0.98 (a/R)^0.38 for a limit on the force (published for high torsion;
/// a rough guide for others).
double expected_length(const Scenario& scenario);

}  // namespace wirepack
