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

/// Model of a scenario: the wire and the nozzle that its seed draws, the energy terms, and the
/// options of its equilibria in its units. `terms` refers to members by their place, so a model
/// cannot be copied or moved.
struct PackingModel {
  /// `extra` are terms of the caller's own; they must outlive the model.
  explicit PackingModel(const Scenario& scenario, const EnergyTerms& extra = {});
  PackingModel(const PackingModel&) = delete;
  PackingModel& operator=(const PackingModel&) = delete;

  Scenario scenario;  ///< as configured
  RodParams wire;     ///< with the rest shape that the seed draws
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

/// Holds what the nozzle holds, and all frames if the wire costs no torsion: they drop out of the
/// minimization then.
HeldUnknowns held_unknowns(const PackingModel& model, const RodState& rod);

/// Brings the wire to an equilibrium: the energy plus what friction dissipates is minimized.
EquilibriumReport minimize(PackingModel& model, RodState& rod);

/// Moves a wire whose equilibrium is a saddle down from it; see solve/stability.hpp.
bool escape_saddle(PackingModel& model, RodState& rod, EquilibriumReport& report);

/// Brings the tip nearly to equilibrium, all else held. A tip that has been pushed on may stick in
/// the wall or in a strand, with more energy than the whole wire has. Relaxing a few nodes there
/// first keeps that local energy from disturbing the whole wire. Leaves a wire alone that is hardly
/// longer than its tip.
SolverWork settle_tip(PackingModel& model, RodState& rod);

}  // namespace wirepack
