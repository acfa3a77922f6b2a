#include "wirepack/contact/friction_params.hpp"

#include <sstream>

#include "wirepack/core/value_problems.hpp"

namespace wirepack {

std::vector<std::string> problems(const FrictionParams& params) {
  std::vector<std::string> found;
  const bool possible = params.static_coefficient >= 0 && params.static_coefficient <= 10;
  require(possible, "friction.static", params.static_coefficient, "must be between 0 and 10",
          found);
  std::ostringstream allowed;
  allowed << "must be between 0 and friction.static = " << params.static_coefficient
          << ": sliding wire is held by no more than resting wire";
  require(!possible || (params.dynamic_coefficient >= 0 &&
                        params.dynamic_coefficient <= params.static_coefficient),
          "friction.dynamic", params.dynamic_coefficient, allowed.str(), found);
  require(params.slip_tolerance >= 1e-4 && params.slip_tolerance <= 0.1, "friction.slip_tolerance",
          params.slip_tolerance, "must be between 1e-4 and 0.1 (wire radii)", found);
  return found;
}

}  // namespace wirepack
