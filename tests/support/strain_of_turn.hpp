#pragma once

#include <cmath>

namespace wirepack::testing {

/// Length of the bending strain of a joint that turns by an angle (joint_strain.hpp).
inline double strain_of_turn(double angle) {
  const double chord = 2 * std::sin(angle / 2), tangent = 2 * std::tan(angle / 2);
  return std::sqrt((2 * chord * chord + tangent * tangent) / 3);
}

}  // namespace wirepack::testing
