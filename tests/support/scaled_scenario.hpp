#pragma once

#include <cmath>
#include <vector>

#include "wirepack/packing/scenario.hpp"

namespace wirepack::testing {

/// The same scenario where a unit of length is `length` times shorter, and so on: every number
/// grows by the factors of its units.
inline Scenario scaled_scenario(Scenario scenario, double length, double modulus, double density) {
  const double time = length * std::sqrt(density / modulus);
  scenario.wire.radius *= length;
  scenario.wire.youngs_modulus *= modulus;
  scenario.wire.edge_length *= length;
  scenario.wire.rest_darboux /= length;
  if (!scenario.wire.reference_shape.empty()) {
    std::vector<DarbouxRow> rows = scenario.wire.reference_shape.table.rows();
    for (DarbouxRow& row : rows) row = {row.arc * length, row.darboux / length};
    scenario.wire.reference_shape.table = DarbouxTable(rows);
  }
  scenario.density *= density;
  scenario.cavity.radius *= length;
  if (scenario.cavity.semi_axes) *scenario.cavity.semi_axes *= length;
  if (scenario.nozzle.position) *scenario.nozzle.position *= length;
  scenario.nozzle.depth *= length;
  scenario.wall_stiffness *= modulus;
  scenario.contact.stiffness *= modulus;
  scenario.contact.excluded_arc_length *= length;
  scenario.insertion.increment *= length;
  if (scenario.stop.length) *scenario.stop.length *= length;
  if (scenario.dynamics.damping) *scenario.dynamics.damping /= time;
  if (scenario.dynamics.insertion_speed) *scenario.dynamics.insertion_speed *= length / time;
  if (scenario.dynamics.time_step) *scenario.dynamics.time_step *= time;
  return scenario;
}

}  // namespace wirepack::testing
