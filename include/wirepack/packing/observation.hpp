#pragma once

#include <vector>

#include "wirepack/packing/history.hpp"
#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/packing_model.hpp"
#include "wirepack/packing/packing_progress.hpp"

namespace wirepack {

/// What a state says by itself. Found once for an equilibrium, and used by friction, row and frame.
struct Observation {
  double energy_stretch = 0, energy_bend = 0, energy_twist = 0, energy_wall = 0, energy_contact = 0;
  std::vector<SelfContact> contacts;  ///< sorted by pairs
  Eigen::VectorXd wall_forces;        ///< N
  double max_overlap = 0;             ///< with the wall, or of strands inside their own edges
};
Observation observe(PackingModel& model, const RodState& rod);

/// A row with what a state alone says: lengths, energies but the total, contacts, overlap.
HistoryRow row_of(const PackingModel& model, const RodState& rod, const Observation& observed);

/// Notes the force of the last row, and the levels that its mean over an edge length is the first
/// to reach.
void note_force(const Scenario& scenario, PackingProgress& progress);

/// phi has grown by output.frame_every_density since the last frame.
bool frame_is_due(const Scenario& scenario, const PackingProgress& progress);

/// The state of the last row as a frame; the next one is counted from here.
PackingFrame take_frame(PackingModel& model, PackingProgress& progress);

}  // namespace wirepack
