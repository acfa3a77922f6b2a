#include "quasistatic_model.hpp"

#include <algorithm>

#include "wirepack/contact/passage.hpp"
#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/rod/rest_strain.hpp"

namespace wirepack {

namespace {

// The Hessian has negative eigenvalues on the way down; this much of it nearly always leaves a positive
// model.
constexpr double curvature_exactness = 0.7;

// What settles by itself when the wire has slid along itself, and how well, over the tolerance of
// rest: a few nodes are quick, and all else is at rest already.
constexpr Index tip_nodes = 5;
constexpr double settled_tolerance = 100;
constexpr int settling_evaluations = 60;

// A straight wire whose rotation is free in a frictionless sphere has no torsion in any minimum, so
// its frames drop out of the minimization. Friction holds its surface and twists it.
bool torsion_free(const Scenario& scenario) {
  return scenario.nozzle_twist == TwistCondition::free && is_straight(scenario.wire) &&
         scenario.friction.model == FrictionModel::none;
}

Stiffness joint_stiffness(const Scenario& scenario) {
  Stiffness s = stiffness(scenario.wire);
  if (torsion_free(scenario)) s.twist = 0;
  return s;
}

std::vector<SelfContact> contacts_of(const Scenario& scenario, QuasistaticModel& model,
                                     const RodState& rod) {
  if (!scenario.contact_enabled) return {};
  model.contact.prepare(rod);
  return model.contact.contacts(rod);
}

EquilibriumReport solve(const Scenario& scenario, QuasistaticModel& model, RodState& rod,
                        HeldUnknowns held, const EquilibriumOptions& options) {
  EquilibriumReport report;
  if (torsion_free(scenario)) {
    held.angle.assign(held.angle.size(), true);
    held.frames_follow = false;
  }
  EnergyTerms energy{model.stretch, model.joints, model.wall};
  if (scenario.contact_enabled) energy.add(model.contact);
  if (scenario.friction.model != FrictionModel::none) energy.add(model.friction);
  report = solve_equilibrium(rod, held, energy, options);
  if (torsion_free(scenario)) remove_twist(rod);
  return report;
}

}  // namespace

QuasistaticModel::QuasistaticModel(const Scenario& scenario, const Nozzle& at)
    : stretch(scenario.wire),
      joints(scenario.wire, joint_stiffness(scenario)),
      wall(scenario.wire, scenario.cavity, scenario.wall_stiffness),
      contact(scenario.wire, scenario.contact),
      friction(scenario.wire, scenario.cavity, scenario.friction),
      nozzle(at) {
  options =
      equilibrium_options(stiffness(scenario.wire).bend, scenario.wire.radius,
                          scenario.minimizer.tolerance * force_unit(scenario), scenario.minimizer);
  // two strands that close in on each other by 0.8 a each still touch on their old sides
  options.guard = {0.8 * scenario.wire.radius,
                   10 * scenario.wire.youngs_modulus * scenario.wire.edge_length, nullptr};
  if (scenario.contact_enabled) {
    const Index separation =
        first_touching_neighbor({2 * scenario.wire.radius, scenario.wire.edge_length,
                                 scenario.contact.excluded_arc_length});
    options.guard.admissible = [separation](const RodState& before, const RodState& after) {
      return passed_pairs(before, after, separation).empty();
    };
  }
}

EquilibriumReport relax(const Scenario& scenario, QuasistaticModel& model, RodState& rod) {
  // A coil turns about the centre almost for free; a wire that is shorter has little to turn.
  const double radius = scenario.cavity.radius;
  const bool coiled = total_rest_length(rod, scenario.wire) > 2 * pi * radius;
  EquilibriumOptions options = model.options;
  options.turning_taper = coiled ? radius : 0;
  options.exactness = curvature_exactness;
  return solve(scenario, model, rod, held_by(model.nozzle, rod), options);
}

SolverWork settle_tip(const Scenario& scenario, QuasistaticModel& model, RodState& rod) {
  if (rod.node_count() <= 2 * tip_nodes) return {};
  HeldUnknowns held = held_by(model.nozzle, rod);
  for (Index i = tip_nodes; i < rod.node_count(); ++i) held.hold_node(i);
  for (std::size_t j = tip_nodes; j < held.angle.size(); ++j) held.angle[j] = true;
  EquilibriumOptions options = model.options;
  options.force_tolerance *= settled_tolerance;
  options.moment_tolerance *= settled_tolerance;
  options.method.max_evaluations = std::min(options.method.max_evaluations, settling_evaluations);
  return solve(scenario, model, rod, held, options).work;
}

SlipWork start_friction(const Scenario& scenario, QuasistaticModel& model, const RodState& rod,
                        std::span<const SlipMemory> memory) {
  if (scenario.friction.model == FrictionModel::none) return {};
  model.friction.start(rod, contacts_of(scenario, model, rod), model.wall.forces(rod), memory);
  return model.friction.work(rod);
}

Index join_friction(const Scenario& scenario, QuasistaticModel& model, const RodState& before,
                    const RodState& rod) {
  if (scenario.friction.model == FrictionModel::none) return 0;
  return model.friction.join(before, rod, contacts_of(scenario, model, rod),
                             model.wall.forces(rod));
}

}  // namespace wirepack
