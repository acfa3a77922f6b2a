// A cantilever that a force at its tip bends far. The exact deflection is that of Bisshopp and
// Drucker (1945) for a force of YI / L^2.
#include <cmath>
#include <cstdio>
#include <exception>

#include <wirepack/energy/joint_energy.hpp>
#include <wirepack/energy/load_energy.hpp>
#include <wirepack/energy/reactions.hpp>
#include <wirepack/energy/stretch_energy.hpp>
#include <wirepack/solve/stability.hpp>

using namespace wirepack;

int main() try {
  constexpr Index edges = 100;
  constexpr double length = 100, exact = 0.30172077;  // deflection over length

  RodParams wire;  // a = 1, Y = 5
  wire.edge_length = length / edges;
  wire.stretch_multiplier = 100;  // nearly inextensible, as the exact rod is
  const double bend = stiffness(wire).bend;

  // Straight along z, clamped at its first node.
  Points nodes = Points::Zero(3, edges + 1);
  for (Index i = 0; i <= edges; ++i) nodes(2, i) = wire.edge_length * static_cast<double>(i);
  RodState rod = make_rod(nodes, wire, {.first_clamped = true});
  HeldUnknowns held = HeldUnknowns::none(rod);
  held.hold_node(0);
  held.angle[static_cast<std::size_t>(rod.first_clamp_frame())] = true;

  Loads loads;
  loads.forces.push_back({edges, Vec3(bend / (length * length), 0, 0)});

  const StretchEnergy stretch(wire);
  const JointEnergy joints(wire);
  const LoadEnergy load(wire, loads);
  const EnergyTerms energy{stretch, joints, load};

  // At rest where no force exceeds 1e-6 YI / L^2; a saddle would be left by at most a wire radius.
  const double tolerance = 1e-6 * bend / (length * length);
  const EquilibriumReport found = solve_stable_equilibrium(
      rod, held, energy, equilibrium_options(bend, length, tolerance), wire.radius);

  Gradient gradient;
  set_zero(gradient, rod);
  for (const NamedEnergy& term : energy.breakdown(rod, gradient)) {
    std::printf("%-8s %10.6f YI/L\n", term.name.data(), term.energy * length / bend);
  }
  set_zero(gradient, rod);
  energy.add_gradient(rod, gradient);
  const double reaction = reactions(rod, gradient)(0, 0) * length * length / bend;
  std::printf("reaction %.6f YI/L^2\n", reaction);
  const double deflection = rod.nodes(0, edges) / length;
  std::printf("deflection %.6f L, exact %.6f L\n", deflection, exact);
  const bool right = std::abs(deflection / exact - 1) < 1e-3 &&
                     std::abs(reaction + 1) < 1e-4;  // errors are of order (l k)^2
  return found.end == EquilibriumEnd::converged && found.stable && right ? 0 : 3;
} catch (const std::exception& error) {  // NumericalFailure: what is given here is valid
  std::fprintf(stderr, "equilibrium_of_a_rod: %s\n", error.what());
  return 4;
}
