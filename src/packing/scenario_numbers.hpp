#pragma once

#include "wirepack/packing/scenario.hpp"

namespace wirepack {

// Of limits: numbers that were converted from other units are off by this much.
inline constexpr double round_off = 1e-9;

/// Calls f(key, number, unit) for every number of a scenario that has a unit, but for the rows of a
/// reference shape; `scenario` may be const.
template <class AScenario, class F>
void for_each_number_with_unit(AScenario& scenario, F&& f) {
  const Units unit = units_of(scenario);
  const auto if_given = [&](const char* key, auto& number, double unit_of_it) {
    if (number) f(key, *number, unit_of_it);
  };
  f("wire.radius", scenario.wire.radius, unit.length);
  f("wire.youngs_modulus", scenario.wire.youngs_modulus, unit.modulus);
  f("wire.density", scenario.density, unit.density);
  f("wire.edge_length", scenario.wire.edge_length, unit.length);
  for (auto& k : scenario.wire.rest_darboux) f("wire.precurvature", k, 1 / unit.length);
  f("cavity.radius", scenario.cavity.radius, unit.length);
  if (scenario.cavity.semi_axes) {
    for (auto& e : *scenario.cavity.semi_axes) f("cavity.semi_axes", e, unit.length);
  }
  if (scenario.nozzle.position) {
    for (auto& x : *scenario.nozzle.position) f("nozzle.position", x, unit.length);
  }
  f("nozzle.depth", scenario.nozzle.depth, unit.length);
  f("cavity.wall_stiffness", scenario.wall_stiffness, unit.modulus);
  f("contact.stiffness", scenario.contact.stiffness, unit.modulus);
  f("contact.excluded_arc_length", scenario.contact.excluded_arc_length, unit.length);
  f("insertion.increment", scenario.insertion.increment, unit.length);
  if_given("stop.length", scenario.stop.length, unit.length);
  if_given("dynamics.damping", scenario.dynamics.damping, 1 / unit.time());
  if_given("dynamics.insertion_speed", scenario.dynamics.insertion_speed,
           unit.length / unit.time());
  if_given("dynamics.time_step", scenario.dynamics.time_step, unit.time());
}

}  // namespace wirepack
