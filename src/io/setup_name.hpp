#pragma once

#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// As pages and figures call a setup.
constexpr const char* setup_name(Setup setup) {
  return setup == Setup::high_torsion ? "high torsion" : "low torsion";
}

}  // namespace wirepack
