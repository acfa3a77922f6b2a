#include "wirepack/verify/known_problem.hpp"

#include <array>
#include <cmath>

#include "wirepack/core/error.hpp"

#include "problems.hpp"

namespace wirepack {

namespace {

constexpr std::array<KnownProblemGroup, 10> groups{{
    {"gradients", gradient_problems},
    {"straight rods", straight_rod_problems},
    {"elastica", elastica_problems},
    {"twisted ring", twisted_ring_problems},
    {"curved rods", curved_rod_problems},
    {"contact", contact_problems},
    {"hoops in a ball", hoop_problems},
    {"fed wire", feeding_problems},
    {"inverse spool", spool_problems},
    {"writhe", writhe_problems},
}};

}  // namespace

double KnownProblem::error() const {
  return exact != 0 ? std::abs(measured / exact - 1) : std::abs(measured);
}

std::span<const KnownProblemGroup> known_problem_groups() { return groups; }

RodParams unit_rod(Index edges, double length, double stretch) {
  RodParams params;
  params.radius = 0.01 * length;
  params.youngs_modulus = 4 / (pi * std::pow(params.radius, 4));
  params.stretch_multiplier = stretch / 4e4;  // YA L^2 / YI = 4 L^2 / a^2
  params.edge_length = length / static_cast<double>(edges);
  return params;
}

Points straight_rod_nodes(Index edges, double length) {
  Points nodes = Points::Zero(3, edges + 1);
  nodes.row(2).setLinSpaced(edges + 1, 0, length);
  return nodes;
}

Points polygon_nodes(Index edges, double radius) {
  Points nodes(3, edges);
  for (Index i = 0; i < edges; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(edges);
    nodes.col(i) = radius * Vec3(std::cos(angle), std::sin(angle), 0);
  }
  return nodes;
}

EquilibriumReport find_equilibrium(RodState& state, const HeldUnknowns& held,
                                   const EnergyTerms& energy, const Tolerances& limits,
                                   double bend_stiffness) {
  const EquilibriumOptions options =
      equilibrium_options(bend_stiffness, limits.moment / limits.force, limits.force);
  const EquilibriumReport report = solve_equilibrium(state, held, energy, options);
  if (report.end != EquilibriumEnd::converged) {
    throw NumericalFailure("no rest was found; the residual is " + std::to_string(report.residual) +
                           " times its tolerance");
  }
  return report;
}

}  // namespace wirepack
