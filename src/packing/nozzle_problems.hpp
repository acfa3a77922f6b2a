#pragma once

#include <string>
#include <vector>

#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// Adds impossible values of [nozzle], as problems() says them. Looks for a nozzle that is outside
/// of the cavity, or feeds the wire out of it, only if nothing was found before.
void check_nozzle(const Scenario& scenario, std::vector<std::string>& found);

}  // namespace wirepack
