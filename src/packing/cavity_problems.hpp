#pragma once

#include <string>
#include <vector>

#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// Impossible sizes of the cavity, and edges that are too long for it, as problems() says them.
std::vector<std::string> cavity_problems(const Scenario& scenario);

}  // namespace wirepack
