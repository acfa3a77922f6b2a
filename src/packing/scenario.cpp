#include "wirepack/packing/scenario.hpp"

#include <algorithm>

#include "wirepack/core/error.hpp"

namespace wirepack {

Scenario default_scenario(Setup setup, const Cavity& cavity, double wire_radius,
                          double youngs_modulus, Method method) {
  Scenario scenario;
  scenario.setup = setup;
  scenario.method = method;
  const bool rubs = method == Method::dynamic;
  if (rubs) scenario.friction.model = FrictionModel::coulomb;
  scenario.cavity = cavity;
  scenario.wire.radius = wire_radius;
  scenario.wire.youngs_modulus = youngs_modulus;
  scenario.wire.edge_length = std::clamp(cavity.radius / 10, wire_radius / 2, 2 * wire_radius);
  if (setup == Setup::high_torsion) {
    scenario.nozzle.twist = TwistCondition::locked;
    scenario.wire.rest_darboux = Vec3(0, 1 / (2 * cavity.radius), 0);
    scenario.wire.edge_length = std::clamp(cavity.radius / 20, wire_radius / 2, 2 * wire_radius);
  }
  scenario.wall_stiffness = youngs_modulus;
  scenario.contact.stiffness = youngs_modulus;
  scenario.contact.excluded_arc_length = pi * wire_radius;
  scenario.insertion.increment = scenario.wire.edge_length / 2;
  scenario.stop.scaled_force = rubs ? 30 : 10;
  return scenario;
}

void require_valid(const Scenario& scenario) {
  std::string text;
  for (const std::string& problem : problems(scenario)) {
    text += (text.empty() ? "" : "\n") + problem;
  }
  if (!text.empty()) throw InvalidInput(text);
}

}  // namespace wirepack
