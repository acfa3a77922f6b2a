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

HistoryRow observe(const Scenario& scenario, SelfContactEnergy& contact, const RodState& rod) {
  HistoryRow row;
  Gradient unused;
  set_zero(unused, rod);
  const JointEnergies joints = joint_energies(scenario.wire, rod);
  row.energy_stretch = StretchEnergy(scenario.wire).add_gradient(rod, unused);
  row.energy_bend = joints.bend;
  row.energy_twist = joints.twist;
  row.energy_wall =
      WallEnergy(scenario.wire, scenario.cavity, scenario.wall_stiffness).add_gradient(rod, unused);
  for (Index i = 0; i < rod.node_count(); ++i) {
    row.max_overlap = std::max(row.max_overlap,
                               -wall_gap(scenario.cavity, rod.nodes.col(i), scenario.wire.radius));
  }
  if (scenario.contact_enabled) {
    contact.prepare(rod);
    row.energy_contact = contact.add_gradient(rod, unused);
    const std::vector<SelfContact> contacts = contact.contacts(rod);
    row.contacts = static_cast<double>(contacts.size());
    for (const SelfContact& touch : contacts) {
      // beyond their own edge the lines are extrapolations of curved strands
      const bool inside = std::abs(touch.line.s) <= 0.5 && std::abs(touch.line.t) <= 0.5;
      if (inside) row.max_overlap = std::max(row.max_overlap, touch.overlap);
    }
  }
  row.inserted_length = total_rest_length(rod, scenario.wire);
  row.packing_density = packing_density(row.inserted_length, scenario.cavity, scenario.wire.radius);
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

PackingFrame take_frame(const Scenario& scenario, SelfContactEnergy& contact,
                        PackingProgress& progress) {
  progress.last_frame_density = progress.last.packing_density;
  PackingFrame frame;
  frame.rod = progress.rod;
  frame.increment = progress.last.increment;
  frame.inserted_length = progress.last.inserted_length;
  frame.packing_density = progress.last.packing_density;
  frame.force = progress.last.force;
  const NodeEnergies energies = node_energies(scenario.wire, progress.rod);
  frame.bend_energy = energies.bend;
  frame.twist_energy = energies.twist;
  const WallEnergy wall(scenario.wire, scenario.cavity, scenario.wall_stiffness);
  frame.wall_force = wall.forces(progress.rod);
  if (scenario.contact_enabled) {
    contact.prepare(progress.rod);
    frame.contacts = contact.contacts(progress.rod);
  }
  return frame;
}

}  // namespace wirepack
