#include "wirepack/packing/packing_model.hpp"

#include <algorithm>

#include "wirepack/contact/passage.hpp"
#include "wirepack/core/error.hpp"
#include "wirepack/packing/imperfection.hpp"
#include "wirepack/rod/rest_strain.hpp"
#include "wirepack/solve/stability.hpp"

namespace wirepack {

namespace {

// Nodes that settle_tip moves, its tolerance over that of an equilibrium, and its evaluations. A
// few nodes are quick, and all others are in equilibrium already.
constexpr Index tip_nodes = 5;
constexpr double settled_tolerance = 100;
constexpr int settling_evaluations = 60;

// Farthest that a node is moved off a saddle, over the wire radius.
constexpr double off_saddle = 0.3;

const Scenario& valid(const Scenario& scenario) {
  require_valid(scenario);
  return scenario;
}

// A straight wire whose rotation is free has no torsion in any minimum without friction, so its
// frames drop out of the minimization. Friction holds its surface and twists it.
bool torsion_free(const Scenario& scenario, const RodParams& wire) {
  return scenario.nozzle.twist == TwistCondition::free && is_straight(wire) &&
         scenario.friction.model == FrictionModel::none;
}

Stiffness joint_stiffness(const Scenario& scenario, const RodParams& wire) {
  Stiffness s = stiffness(wire);
  if (torsion_free(scenario, wire)) s.twist = 0;
  return s;
}

EquilibriumOptions options_of(const Scenario& scenario) {
  const RodParams& wire = scenario.wire;
  const double force = scenario.minimizer.tolerance * force_unit(scenario);
  EquilibriumOptions options =
      equilibrium_options(stiffness(wire).bend, wire.radius, force, scenario.minimizer);
  // two strands that close in on each other by 0.8 a each still touch on their old sides
  options.guard.distance = 0.8 * wire.radius;
  options.guard.stiffness = 10 * wire.youngs_modulus * wire.edge_length;
  // friction asks for the way, not only where it leads
  if (scenario.friction.model == FrictionModel::none) {
    options.guard.snap_distance = 8 * options.guard.distance;
  }
  if (scenario.contact_enabled) {
    const Index separation = first_touching_neighbor(
        {2 * wire.radius, wire.edge_length, scenario.contact.excluded_arc_length});
    options.guard.admissible = [separation](const RodState& before, const RodState& after) {
      return passed_pairs(before, after, separation).empty();
    };
  }
  return options;
}

}  // namespace

HeldUnknowns held_unknowns(const PackingModel& model, const RodState& rod) {
  HeldUnknowns held = held_by(model.nozzle, rod);
  if (torsion_free(model.scenario, model.wire)) {
    held.angle.assign(held.angle.size(), true);
    held.frames_follow = false;
  }
  return held;
}

PackingModel::PackingModel(const Scenario& configured, const EnergyTerms& extra)
    : scenario(valid(configured)),
      wire(drawn_setup(scenario).wire),
      nozzle(drawn_setup(scenario).nozzle),
      stretch(wire),
      joints(wire, joint_stiffness(scenario, wire)),
      wall(wire, scenario.cavity, scenario.wall_stiffness),
      contact(wire, scenario.contact),
      friction(wire, scenario.cavity, scenario.friction),
      terms{stretch, joints, wall},
      options(options_of(scenario)) {
  if (scenario.contact_enabled) terms.add(contact);
  if (has_friction()) terms.add(friction);
  terms.add(extra);
}

EquilibriumReport minimize(PackingModel& model, RodState& rod) {
  // A coil turns about the centre almost for free; a wire that is shorter has little to turn.
  const double radius = model.scenario.cavity.radius;
  const bool coiled = total_rest_length(rod, model.wire) > 2 * pi * radius;
  EquilibriumOptions options = model.options;
  options.turning_taper = coiled ? radius : 0;
  const EquilibriumReport report =
      solve_equilibrium(rod, held_unknowns(model, rod), model.terms, options);
  if (torsion_free(model.scenario, model.wire)) remove_twist(rod);
  return report;
}

bool escape_saddle(PackingModel& model, RodState& rod, EquilibriumReport& report) {
  return escape_saddle(rod, held_unknowns(model, rod), model.terms, model.options,
                       off_saddle * model.wire.radius, report);
}

SolverWork settle_tip(PackingModel& model, RodState& rod) {
  if (rod.node_count() <= 2 * tip_nodes) return {};
  HeldUnknowns held = held_unknowns(model, rod);
  for (Index i = tip_nodes; i < rod.node_count(); ++i) held.hold_node(i);
  for (std::size_t j = tip_nodes; j < held.angle.size(); ++j) held.angle[j] = true;
  EquilibriumOptions options = model.options;
  options.force_tolerance *= settled_tolerance;
  options.moment_tolerance *= settled_tolerance;
  options.method.max_evaluations = std::min(options.method.max_evaluations, settling_evaluations);
  const EquilibriumReport report = solve_equilibrium(rod, held, model.terms, options);
  if (torsion_free(model.scenario, model.wire)) remove_twist(rod);
  return report.work;
}

}  // namespace wirepack
