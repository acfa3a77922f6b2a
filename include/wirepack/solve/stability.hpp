#pragma once

#include "wirepack/solve/equilibrium.hpp"

namespace wirepack {

/// Hessian of an energy at the chart's reference, by the unknowns of the chart: its lower triangle.
/// As far as the terms know it (see EnergyTerm).
Eigen::SparseMatrix<double> hessian(const FrameChart& chart, const EnergyTerms& energy);

/// Softest way for a wire to move.
struct CurvatureMode {
  double eigenvalue;
  Eigen::VectorXd direction;  ///< by the unknowns of a FrameChart of the state
};

/// Lowest eigenvalue of the Hessian against its Gauss-Newton part, H v = lambda P v, by Lanczos's
/// method. It has no unit: under a load of (1 - e) times the buckling load it is about e. Of no use
/// where P itself has no stiffness, as for a rod that nothing holds, or that only friction keeps
/// from turning about its axis.
CurvatureMode softest_mode(const RodState& state, const HeldUnknowns& held,
                           const EnergyTerms& energy, const EquilibriumOptions& options,
                           SolverWork& work);

/// Whether an equilibrium is a minimum. The eigenvalue is that of the softest mode.
struct Stability {
  bool stable = true;
  double lowest_eigenvalue = 0;  ///< computed only where it is below that of a minimum
  Eigen::VectorXd direction;  ///< its eigenvector, by the unknowns of a FrameChart; empty if stable
};

/// The search escapes from so many saddles in a row; from one with several directions down, along
/// one after the other.
inline constexpr int most_saddles = 6;

/// Tells a minimum from a saddle, to a hundredth of a per cent of the load: one factorization of
/// the Hessian with 1e-4 of its Gauss-Newton part, and where that meets a pivot that is not
/// positive, the softest mode. `order`: that of an EquilibriumReport, which saves finding one.
Stability stability_of(const RodState& state, const HeldUnknowns& held, const EnergyTerms& energy,
                       const EquilibriumOptions& options, SolverWork& work,
                       const std::vector<int>& order = {});

/// Moves a state that is a saddle down from it, along the direction of the lowest
/// curvature, by at least `length` / 1000 at a node and at most by `length`. Returns whether it has
/// moved; sets `report.stable`, and adds to its work.
bool escape_saddle(RodState& state, const HeldUnknowns& held, const EnergyTerms& energy,
                   const EquilibriumOptions& options, double length, EquilibriumReport& report);

/// Like solve_equilibrium, but escapes from saddles. `report.stable` says how it ended.
EquilibriumReport solve_stable_equilibrium(RodState& state, const HeldUnknowns& held,
                                           const EnergyTerms& energy,
                                           const EquilibriumOptions& options, double length);

}  // namespace wirepack
