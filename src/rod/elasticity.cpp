#include "wirepack/rod/elasticity.hpp"

#include <cmath>

namespace wirepack {

Elasticity elasticity_of(const Stiffness& stiffness, double radius) {
  const double area = pi * radius * radius;
  const double modulus = stiffness.bend / (area * radius * radius / 4);
  return {modulus, stiffness.bend / stiffness.twist - 1, stiffness.stretch / (modulus * area)};
}

Stiffness stiffness(const WoundCoil& coil) {
  const double mean_diameter = coil.coil_diameter - coil.wire_diameter;
  const double shear_modulus = coil.youngs_modulus / (2 * (1 + coil.poisson_ratio));
  const double fifth_power = std::pow(coil.wire_diameter, 5);
  return {shear_modulus * fifth_power / (8 * std::pow(mean_diameter, 3)),
          coil.youngs_modulus * fifth_power / (32 * mean_diameter * (2 + coil.poisson_ratio)),
          coil.youngs_modulus * fifth_power / (64 * mean_diameter)};
}

}  // namespace wirepack
