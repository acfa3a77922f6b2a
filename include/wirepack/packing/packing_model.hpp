#pragma once

#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/self_contact_energy.hpp"
#include "wirepack/energy/slip_potential.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/energy/wall_energy.hpp"
#include "wirepack/feed/nozzle.hpp"
#include "wirepack/packing/scenario.hpp"
#include "wirepack/solve/equilibrium.hpp"

namespace wirepack {

/// What a scenario is made of: the wire and the nozzle of its seed, the energy terms, and how an
/// equilibrium is looked for in its units. Terms refer to each other's place, so a model stays
/// where it is.
struct PackingModel {
  /// `extra` are terms of the caller's own; they must outlive the model.
  explicit PackingModel(const Scenario& scenario, const EnergyTerms& extra = {});
  PackingModel(const PackingModel&) = delete;
  PackingModel& operator=(const PackingModel&) = delete;

  Scenario scenario;  ///< as configured
  RodParams wire;     ///< with the rest shape that the seed makes
  Nozzle nozzle;
  StretchEnergy stretch;
  JointEnergy joints;
  WallEnergy wall;
  SelfContactEnergy contact;
  SlipPotential friction;
  EnergyTerms terms;
  EquilibriumOptions options;

  bool has_friction() const { return scenario.friction.model != FrictionModel::none; }
};

/// Brings the wire to a minimum of the energy and of what friction dissipates on the way.
EquilibriumReport minimize(PackingModel& model, RodState& rod);

/// Moves a wire that has come to rest on a saddle down from it; see leave_saddle
/// (solve/stability.hpp).
bool leave_saddle(PackingModel& model, RodState& rod, EquilibriumReport& report);

/// Brings the tip nearly to rest, all else held. A tip that has been pushed on may stick in the
/// wall or in a strand, with more energy than the whole wire has. Relaxing a few nodes there first
/// keeps that local energy from disturbing the whole wire. Nothing for a wire that is hardly more
/// than a tip.
SolverWork settle_tip(PackingModel& model, RodState& rod);

}  // namespace wirepack
