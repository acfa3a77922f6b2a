#pragma once

#include <string>
#include <vector>

#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// Adds impossible values of [nozzle], as problems() says them. Whether the nozzle is outside of the
/// cavity, or would feed the wire out of it, is asked only if nothing was found before.
void check_nozzle(const Scenario& scenario, std::vector<std::string>& found);

}  // namespace wirepack
