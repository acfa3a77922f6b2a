#pragma once

#include <vector>

#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/solve/equilibrium.hpp"
#include "wirepack/verify/known_problem.hpp"

namespace wirepack {

std::vector<KnownProblem> gradient_problems();
std::vector<KnownProblem> straight_rod_problems();
std::vector<KnownProblem> elastica_problems();
std::vector<KnownProblem> twisted_ring_problems();
std::vector<KnownProblem> curved_rod_problems();
std::vector<KnownProblem> contact_problems();
std::vector<KnownProblem> hoop_problems();
std::vector<KnownProblem> feeding_problems();
std::vector<KnownProblem> spool_problems();
std::vector<KnownProblem> writhe_problems();

/// A rod with YI = 1 and this YA L^2 / YI, in `edges` edges.
RodParams unit_rod(Index edges, double length, double stretch);

/// Nodes of a straight rod along z from the origin, and of a regular polygon about z.
Points straight_rod_nodes(Index edges, double length);
Points polygon_nodes(Index edges, double radius);

/// Largest force and moment left in equilibrium.
struct Tolerances {
  double force, moment;
};
/// Moves the state to an equilibrium; throws NumericalFailure when none is found.
EquilibriumReport find_equilibrium(RodState& state, const HeldUnknowns& held,
                                   const EnergyTerms& energy, const Tolerances& limits,
                                   double bend_stiffness);

}  // namespace wirepack
