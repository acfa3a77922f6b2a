#pragma once

#include "wirepack/solve/equilibrium.hpp"

namespace wirepack {

// The lowest point that a search has seen.
struct LowestPoint {
  RodState state;
  Energy energy;            // without the guard's
  double guard_energy = 0;  // > 0: not in equilibrium yet
  double residual = HUGE_VAL;
  double inlet_length_force = 0;
};

// Goes down from `lowest` with one chart, one factor and one memory of L-BFGS; `lowest` is the
// lowest point afterwards. Returns what the energy has lost, the guard's included; throws
// NumericalFailure where the start has no finite energy.
double descend_one_round(LowestPoint& lowest, const HeldUnknowns& held, const EnergyTerms& energy,
                         const EquilibriumOptions& options, double guard_distance,
                         int max_evaluations, SolverWork& work);

}  // namespace wirepack
