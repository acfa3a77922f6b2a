#pragma once

#include <map>
#include <string>
#include <vector>

#include "wirepack/packing/declared_units.hpp"

namespace wirepack {

/// Numbers of a configuration by the paths of their keys.
using GivenNumbers = std::map<std::string, double, std::less<>>;

struct KeyProblem {
  std::string path, problem;
};

/// Stiffness as users know it: [wire] bending_stiffness, torsional_stiffness, persistence_length
/// with temperature, or [wire.coil]. Adds the keys that they stand for, wire.youngs_modulus,
/// poisson_ratio, stretch_multiplier, radius, where they are not given; says which keys cannot be
/// together or cannot be at all. A persistence length without declared units is one in nm and pN,
/// which are declared then.
std::vector<KeyProblem> resolve_stiffness(GivenNumbers& numbers, DeclaredUnits& units);

}  // namespace wirepack
