#pragma once

#include "wirepack/solve/equilibrium.hpp"

namespace wirepack {

/// Curvature of an energy at an equilibrium. The lowest eigenvalue is that of the Hessian against
/// its Gauss-Newton part, H v = lambda P v, so it has no unit: under a load of (1 + e) times the
/// buckling load it is about -e.
struct Stability {
  bool stable = true;
  double lowest_eigenvalue = 0;  ///< computed only where the Hessian is not positive definite
  Eigen::VectorXd direction;  ///< its eigenvector, by the unknowns of a FrameChart; empty if stable
};

/// So many saddles in a row are left; one that has several directions down is left along one after
/// the other.
inline constexpr int most_saddles = 6;

/// Tells a minimum from a saddle: one factorization of the exact Hessian, and where that meets a
/// pivot that is not positive, the lowest eigenvalue by Lanczos's method.
Stability stability_of(const RodState& state, const HeldUnknowns& held, const EnergyTerms& energy,
                       const EquilibriumOptions& options, SolverWork& work);

/// Moves a state that has come to rest on a saddle down from it, along the direction of the lowest
/// curvature, by at least `length` / 1000 at a node and at most by `length`. Returns whether it has
/// moved; sets `report.stable`, and adds to its work.
bool leave_saddle(RodState& state, const HeldUnknowns& held, const EnergyTerms& energy,
                  const EquilibriumOptions& options, double length, EquilibriumReport& report);

/// Like solve_equilibrium, but leaves saddles. `report.stable` says how it ended.
EquilibriumReport solve_stable_equilibrium(RodState& state, const HeldUnknowns& held,
                                           const EnergyTerms& energy,
                                           const EquilibriumOptions& options, double length);

}  // namespace wirepack
