#include "wirepack/packing/observation.hpp"

#include <algorithm>
#include <cmath>

#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/energy/wall_energy.hpp"
#include "wirepack/observe/packing_density.hpp"

namespace wirepack {

namespace {

void note_crossings(std::vector<ForceCrossing>& crossings, double force, double density) {
  // levels 10^(k/2) from 10^-3 on; a force passes each of them once
  for (int k = static_cast<int>(crossings.size()) - 6;; ++k) {
    const double level = std::pow(10.0, k / 2.0);
    if (!(force >= level)) return;
    crossings.push_back({level, density});
  }
}

}  // namespace

Observation observe(PackingModel& model, const RodState& rod) {
  Observation seen;
  const Scenario& scenario = model.scenario;
  const JointEnergies joints = joint_energies(model.wire, rod);
  seen.energy_bend = joints.bend;
  seen.energy_twist = joints.twist;
  Gradient unused;
  set_zero(unused, rod);
  seen.energy_stretch = model.stretch.add_gradient(rod, unused);
  seen.energy_wall = model.wall.add_gradient(rod, unused);
  seen.wall_forces = model.wall.forces(rod);
  for (Index i = 0; i < rod.node_count(); ++i) {
    seen.max_overlap =
        std::max(seen.max_overlap, -wall_gap(scenario.cavity, rod.nodes.col(i), model.wire.radius));
  }
  if (!scenario.contact_enabled) return seen;
  model.contact.prepare(rod);
  seen.energy_contact = model.contact.add_gradient(rod, unused);
  seen.contacts = model.contact.contacts(rod);
  for (const SelfContact& touch : seen.contacts) {
    // beyond their own edge the lines are extrapolations of curved strands
    const bool inside = std::abs(touch.line.s) <= 0.5 && std::abs(touch.line.t) <= 0.5;
    if (inside) seen.max_overlap = std::max(seen.max_overlap, touch.overlap);
  }
  return seen;
}

HistoryRow row_of(const PackingModel& model, const RodState& rod, const Observation& observed) {
  HistoryRow row;
  row.energy_stretch = observed.energy_stretch;
  row.energy_bend = observed.energy_bend;
  row.energy_twist = observed.energy_twist;
  row.energy_wall = observed.energy_wall;
  row.energy_contact = observed.energy_contact;
  row.contacts = static_cast<double>(observed.contacts.size());
  row.max_overlap = observed.max_overlap;
  row.inserted_length = total_rest_length(rod, model.wire);
  row.packing_density =
      packing_density(row.inserted_length, model.scenario.cavity, model.wire.radius);
  return row;
}

void note_force(const Scenario& scenario, PackingProgress& progress) {
  const double edge_length = scenario.wire.edge_length, density = progress.last.packing_density;
  note_force(edge_length, progress.last, progress.recent_forces);
  const std::optional<double> force = mean_force(edge_length, progress.recent_forces);
  if (!force) return;
  const Units units = units_of(scenario);
  note_crossings(progress.scaled_crossings, *force / units.scaled_force(), density);
  note_crossings(progress.absolute_crossings, *force / units.force(), density);
}

bool frame_is_due(const Scenario& scenario, const PackingProgress& progress) {
  return progress.last.packing_density >=
         progress.last_frame_density + scenario.output.frame_every_density;
}

PackingFrame take_frame(PackingModel& model, PackingProgress& progress) {
  progress.last_frame_density = progress.last.packing_density;
  PackingFrame frame;
  frame.rod = progress.rod;
  frame.increment = progress.last.increment;
  frame.inserted_length = progress.last.inserted_length;
  frame.packing_density = progress.last.packing_density;
  frame.force = progress.last.force;
  const NodeEnergies energies = node_energies(model.wire, progress.rod);
  frame.bend_energy = energies.bend;
  frame.twist_energy = energies.twist;
  Observation observed = observe(model, progress.rod);
  frame.wall_force = std::move(observed.wall_forces);
  frame.contacts = std::move(observed.contacts);
  return frame;
}

}  // namespace wirepack
