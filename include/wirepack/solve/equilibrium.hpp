#pragma once

#include <functional>
#include <vector>

#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/rod/frame_chart.hpp"
#include "wirepack/rod/rod_state.hpp"
#include "wirepack/solve/minimizer.hpp"
#include "wirepack/solve/solver_work.hpp"

namespace wirepack {

struct MinimizerOptions {
  double tolerance = 1e-4;      ///< largest gradient component in equilibrium, over YI / R^2
  int max_evaluations = 20000;  ///< per equilibrium
  int memory = 20;              ///< vector pairs of L-BFGS
  int refactor_every = 35;      ///< most evaluations with one factor of the Hessian's model
  double shift = 1e-6;          ///< added to the diagonal of the Hessian's model, over YI / a^3
  DescentMethod method = DescentMethod::nlopt_lbfgs;
};

/// Keeps strands from jumping through each other on the way down. Within one round (one factor, one
/// memory of L-BFGS), a spring of this stiffness pushes back a node that moves across its own wire
/// by more than `distance`. A round that has come near that ends, so a long way takes several
/// rounds; from the fifth in a row on the distance doubles, up to `snap_distance`. Equilibrium is
/// judged without the springs. A round that is not admissible is taken back and repeated with half
/// the distance, down to a sixteenth.
struct MoveGuard {
  double distance = 0;   ///< 0: no guard
  double stiffness = 0;  ///< [force / length]
  /// True if the wire can have gone straight from one state to the other; without it always.
  std::function<bool(const RodState& before, const RodState& after)> admissible = nullptr;
  double snap_distance = 0;  ///< 0: the distance never grows
};

/// Tolerances of an equilibrium and how it is looked for, in the units of the energy.
struct EquilibriumOptions {
  double force_tolerance;   ///< on components of dE/dr
  double moment_tolerance;  ///< on dE/d(angle)
  double shift;             ///< on the diagonal of the Hessian's model [force / length]; for angles
                            ///< it is times (moment_tolerance / force_tolerance)^2
  MinimizerOptions method;  ///< evaluations, memory, refactoring
  MoveGuard guard = {};
  /// Share of the Hessian in its model; 0 takes its place where the model is not positive definite.
  double exactness = 0;
  double turning_taper = 0;  ///< > 0: steps follow a rotation of the whole wire (TurningChart)
};

/// Options in any units, for a wire with this bending stiffness YI [force length^2]. `length` is a
/// length of the problem, in a packing the wire radius. The moment tolerance is force_tolerance
/// times it, and method.shift is over YI / length^3.
EquilibriumOptions equilibrium_options(double bend_stiffness, double length, double force_tolerance,
                                       const MinimizerOptions& method = {});

enum class EquilibriumEnd { converged, evaluation_limit, stalled, inadmissible };

struct EquilibriumReport {
  EquilibriumEnd end = EquilibriumEnd::stalled;
  double energy = 0;
  bool stable = true;             ///< a minimum and no saddle, where that was asked for
  double residual = 0;            ///< largest gradient component over its tolerance; 1 at most
                                  ///< in equilibrium
  double inlet_length_force = 0;  ///< explicit dE/d(inlet_rest_length): the injection force
  SolverWork work;
  std::vector<int> order;  ///< of elimination, of the last factor (Preconditioner::factored)
};

/// Moves `state` down to an equilibrium by L-BFGS, in variables preconditioned by a factor of the
/// Hessian's model, or of its Gauss-Newton part alone if the model is not positive definite. Factor
/// and chart are renewed in rounds. The gradient alone tells convergence, so the equilibrium may be
/// a saddle. `state` is the lowest point found, also if it has not converged. Throws
/// NumericalFailure if even the start has no finite energy.
EquilibriumReport solve_equilibrium(RodState& state, const HeldUnknowns& held,
                                    const EnergyTerms& energy, const EquilibriumOptions& options);

}  // namespace wirepack
