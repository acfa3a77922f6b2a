#pragma once

#include "wirepack/rod/rod_params.hpp"

namespace wirepack {

/// What makes the material of a solid round wire in RodParams.
struct Elasticity {
  double youngs_modulus, poisson_ratio, stretch_multiplier;
};

/// The solid round wire of this radius that has these stiffnesses: Y = EI / (pi a^4 / 4), nu = EI /
/// GJ - 1, and EA over Y pi a^2. A Poisson ratio above 0.5 stands for a wire that twists more
/// easily than any solid one.
Elasticity elasticity_of(const Stiffness& stiffness, double radius);

/// A close-wound helical spring of round stock: turns that touch, without a force between them.
struct WoundCoil {
  double wire_diameter;   ///< d, of the stock [length]
  double coil_diameter;   ///< of the outside, above 2 d [length]
  double youngs_modulus;  ///< E, of the stock [force / length^2]
  double poisson_ratio;   ///< nu, of the stock
};

/// Stiffnesses of the coil as a rod. With the mean diameter D and the pitch d:
///   EA = G d^5 / (8 D^3),  EI = E d^5 / (32 D (2 + nu)),  GJ = E d^5 / (64 D),
///   G = E / (2 (1 + nu)),
/// of one turn of a slender curved bar that is twisted by a pull, bent and twisted by a moment
/// across the axis, and bent by one along it (Timoshenko, Strength of Materials, part I, on
/// close-coiled helical springs; Timoshenko and Gere, Theory of Elastic Stability, on the buckling
/// of helical springs). Stresses in stock as thick as D / 4 are off by some percent.
Stiffness stiffness(const WoundCoil& coil);

}  // namespace wirepack
