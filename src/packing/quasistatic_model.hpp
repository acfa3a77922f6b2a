#pragma once

#include <span>
#include <vector>

#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/self_contact_energy.hpp"
#include "wirepack/energy/slip_potential.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/energy/wall_energy.hpp"
#include "wirepack/feed/nozzle.hpp"
#include "wirepack/packing/scenario.hpp"
#include "wirepack/solve/equilibrium.hpp"

namespace wirepack {

/// The energy terms of one scenario, and what rest means in its units.
struct QuasistaticModel {
  QuasistaticModel(const Scenario& scenario, const Nozzle& at);

  StretchEnergy stretch;
  JointEnergy joints;
  WallEnergy wall;
  SelfContactEnergy contact;
  SlipPotential friction;
  Nozzle nozzle;
  EquilibriumOptions options;
};

/// Brings the wire to rest.
EquilibriumReport relax(const Scenario& scenario, QuasistaticModel& model, RodState& rod);

/// Brings the tip nearly to rest, all else held. A tip that has been pushed on may stick in the wall or in a
/// strand, with more energy than the whole wire has: it gives way alone, before that throws all of the
/// wire about. Nothing for a wire that is hardly more than a tip.
SolverWork settle_tip(const Scenario& scenario, QuasistaticModel& model, RodState& rod);

/// Friction looks back to this state until the next one is at rest.
SlipWork start_friction(const Scenario& scenario, QuasistaticModel& model, const RodState& rod,
                        std::span<const SlipMemory> memory);

/// Contacts that have formed since `before` take part from where they came into touch on. Returns how many.
Index join_friction(const Scenario& scenario, QuasistaticModel& model, const RodState& before,
                    const RodState& rod);

}  // namespace wirepack
