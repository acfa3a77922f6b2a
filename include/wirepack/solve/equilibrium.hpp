#pragma once

#include <functional>

#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/rod/frame_chart.hpp"
#include "wirepack/rod/rod_state.hpp"
#include "wirepack/solve/solver_work.hpp"

namespace wirepack {

struct MinimizerOptions {
  double tolerance = 1e-4;      ///< largest gradient component at rest, over YI / R^2
  int max_evaluations = 20000;  ///< per equilibrium
  int memory = 20;              ///< vector pairs of L-BFGS
  int refactor_every = 35;      ///< most evaluations with one factor of the curvature model
  double shift = 1e-6;          ///< added to the curvature model's diagonal, over YI / a^3
};

/// Keeps strands from jumping through each other on the way down. Within one round (one factor, one
/// memory of L-BFGS), a node that moves across its own wire by more than `distance` is pushed back
/// with this stiffness, and a round that has come near that ends, so a long way is gone in several;
/// rest is judged without it. A round that is not admissible is taken back and repeated with half
/// the distance, down to a sixteenth.
struct MoveGuard {
  double distance = 0;   ///< 0: no guard
  double stiffness = 0;  ///< [force / length]
  /// Whether the wire can have gone straight from one state to the other; none: always.
  std::function<bool(const RodState& before, const RodState& after)> admissible = nullptr;
};

/// What counts as rest and how it is looked for, in the units of the energy.
struct EquilibriumOptions {
  double force_tolerance;   ///< on components of dE/dr
  double moment_tolerance;  ///< on dE/d(angle)
  double shift;             ///< on the curvature model's diagonal [force / length]; for angles it
                            ///< is times (moment_tolerance / force_tolerance)^2
  MinimizerOptions method;  ///< evaluations, memory, refactoring
  MoveGuard guard = {};
  /// Of the curvature model: how much it is the Hessian instead of squares, where that is positive.
  double exactness = 0;
  double turning_taper = 0;  ///< > 0: steps follow a rotation of the whole wire (TurningChart)
};

/// Options in any units, for a wire with this bending stiffness YI [force length^2]: moments are at
/// rest to within force_tolerance times `length`, a length of what is looked for (the radius in a
/// packing), and the shift is over YI / length^3.
EquilibriumOptions equilibrium_options(double bend_stiffness, double length, double force_tolerance,
                                       const MinimizerOptions& method = {});

enum class EquilibriumEnd { converged, evaluation_limit, stalled, inadmissible };

struct EquilibriumReport {
  EquilibriumEnd end = EquilibriumEnd::stalled;
  double energy = 0;
  bool stable = true;             ///< a minimum and no saddle, where that was asked for
  double residual = 0;            ///< largest gradient component over its tolerance; <= 1 at rest
  double inlet_length_force = 0;  ///< explicit dE/d(inlet_rest_length): the injection force
  SolverWork work;
};

/// Moves `state` to a local minimum of the energy: L-BFGS in variables preconditioned by a factor
/// of the curvature model, of its squares alone where they and the Hessian together are not
/// positive; the factor and the chart are renewed in rounds. Judged by the gradient alone. `state`
/// is the best point found, also when it has not converged. Throws NumericalFailure if even the
/// start has no finite energy.
EquilibriumReport solve_equilibrium(RodState& state, const HeldUnknowns& held,
                                    const EnergyTerms& energy, const EquilibriumOptions& options);

}  // namespace wirepack
