#pragma once

#include "wirepack/energy/self_contact_energy.hpp"
#include "wirepack/packing/history.hpp"
#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/packing_progress.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// What a state alone says of a row: lengths, energies but the total, contacts, overlap. `contact` is
/// the term of the scenario, whose neighbor list is used again.
HistoryRow observe(const Scenario& scenario, SelfContactEnergy& contact, const RodState& rod);

/// Notes the force of the last row, and the levels that its mean over an edge length is the first to reach.
void note_force(const Scenario& scenario, PackingProgress& progress);

/// phi has grown by output.frame_every_density since the last frame.
bool frame_is_due(const Scenario& scenario, const PackingProgress& progress);

/// The state of the last row as a frame; the next one is counted from here.
PackingFrame take_frame(const Scenario& scenario, SelfContactEnergy& contact,
                        PackingProgress& progress);

}  // namespace wirepack
