#pragma once

#include <cmath>

namespace wirepack {

/// What the numbers of a packing are measured in. Radius, Young's modulus and density of the wire
/// make units of everything; forces and energies of its bending are seen over YI/R^2 and YI/R.
struct Units {
  double length;         ///< a
  double modulus;        ///< Y [force / length^2]
  double density;        ///< rho [mass / length^3]
  double cavity_radius;  ///< R [length]
  double bend;           ///< YI [force length^2]

  double force() const { return modulus * length * length; }
  double energy() const { return force() * length; }
  double time() const { return length * std::sqrt(density / modulus); }
  double power() const { return energy() / time(); }
  double scaled_force() const { return bend / (cavity_radius * cavity_radius); }
  double scaled_energy() const { return bend / cavity_radius; }
};

}  // namespace wirepack
