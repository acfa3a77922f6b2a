#pragma once

#include "wirepack/dynamics/inertia.hpp"
#include "wirepack/energy/gradient.hpp"

namespace wirepack {

/// Accelerations of a moving wire.
struct Rates {
  Eigen::VectorXd node;  ///< 3N
  Eigen::VectorXd spin;  ///< one per frame
};

/// Equations of motion. `gradient` holds minus the forces on the nodes and minus the moments on the
/// frames (dE/dr and dE/dspin of the energies; friction subtracts its own). The moment M on the
/// frame of an edge of length |e| turns the spin with its part along the tangent t, and the edge
/// with the rest, through a couple of forces +-(M x t) / |e| on its nodes (d'Alembert with the
/// spins t x dt + t dspin of an adapted frame).
///
/// A spinning edge carries the angular momentum I spin_rate t. Turning t needs the moment
/// I spin_rate t', which its nodes feel as the gyroscopic couple +-I spin_rate (t x t') / |e|. It
/// does no work; with it the angular momentum of masses and spins together is conserved exactly in
/// continuous time.
///
/// `motion` must be that of `state`. Reuses the memory of `rates`; held coordinates get 0.
void set_rates(const DynamicState& state, const WireMotion& motion, const Inertia& inertia,
               const Gradient& gradient, Rates& rates);

}  // namespace wirepack
