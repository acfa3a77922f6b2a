// The pieces of an increment in a loop of your own: wire is fed into a sphere from its side, and
// the softest mode tells how far the wire is from its next instability.
#include <cstdio>
#include <exception>

#include <wirepack/feed/feeder.hpp>
#include <wirepack/packing/equilibrate.hpp>
#include <wirepack/solve/stability.hpp>

using namespace wirepack;

int main() try {
  Scenario scenario = default_scenario(Setup::low_torsion, {10});
  scenario.nozzle.position = Vec3(9, 0, 0);
  scenario.imperfection.nozzle_tilt = 0.1;  // a wire that is exactly straight would not buckle
  PackingModel model(scenario);
  const double edge = model.wire.edge_length;
  RodState rod = initial_wire(model.nozzle, model.wire, 0.6 * edge);
  std::vector<SlipMemory> memory;  // what friction hands on to the next increment

  std::printf("   length   force R^2/YI  softest mode\n");
  for (int k = 1; k <= 80; ++k) {
    if (split_is_due(rod, 1.1 * edge)) split_inlet(rod, model.nozzle, model.wire);
    if (model.has_friction()) start_friction(model, rod, observe(model, rod), memory);
    const RodState before = rod;
    insert(rod, edge / 2);
    const Equilibrium found = equilibrate(model, before, rod);
    if (found.report.end != EquilibriumEnd::converged) return 3;
    if (model.has_friction()) memory = model.friction.memory(rod);
    if (k % 8 != 0) continue;
    SolverWork work;
    const CurvatureMode softest =
        softest_mode(rod, held_unknowns(model, rod), model.terms, model.options, work);
    std::printf("%9.2f %14.3f %13.4f\n", total_rest_length(rod, model.wire),
                found.report.inlet_length_force / force_unit(scenario), softest.eigenvalue);
    if (softest.eigenvalue < 0) return 3;  // an equilibrium is a minimum
  }
  return 0;
} catch (const std::exception& error) {  // NumericalFailure: what is given here is valid
  std::fprintf(stderr, "own_feed_loop: %s\n", error.what());
  return 4;
}
