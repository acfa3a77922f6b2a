#pragma once

#include <vector>

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

struct RoundReport {
  double gain;             // by how much the energy has decreased, the guard's included
  bool at_guard;           // a node has come near the guard's distance
  std::vector<int> order;  // of elimination
};

// Descends from `lowest` with one chart, one factor and one memory of L-BFGS, and sets it to the
// lowest point found. Throws NumericalFailure if the start has no finite energy.
RoundReport descend_one_round(LowestPoint& lowest, const HeldUnknowns& held,
                              const EnergyTerms& energy, const EquilibriumOptions& options,
                              double guard_distance, int max_evaluations, SolverWork& work);

}  // namespace wirepack
