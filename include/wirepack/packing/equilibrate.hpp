#pragma once

#include "wirepack/packing/observation.hpp"
#include "wirepack/packing/packing_model.hpp"

namespace wirepack {

/// Where a wire has come to rest, and what was found there.
struct Equilibrium {
  EquilibriumReport report;  ///< its energy without what went against friction
  Observation observed;      ///< of a state that has converged
  SlipWork slip;             ///< since friction has started
};

/// Friction looks back to this state, its contacts and what the last increment handed on, until the
/// next equilibrium. Returns what the contacts' springs hold from before.
SlipWork start_friction(PackingModel& model, const RodState& rod, const Observation& observed,
                        std::span<const SlipMemory> memory);

/// Brings `rod`, fed from the equilibrium `before`, to a minimum. Contacts that form on the way
/// take part from where they came into touch, until none joins any more.
Equilibrium equilibrate(PackingModel& model, const RodState& before, RodState& rod);

}  // namespace wirepack
