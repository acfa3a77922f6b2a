#pragma once

#include "wirepack/packing/observation.hpp"
#include "wirepack/packing/packing_model.hpp"

namespace wirepack {

/// Equilibrium that a wire has come to, and what was found there.
struct Equilibrium {
  EquilibriumReport report;  ///< its energy leaves out the work against friction
  Observation observed;      ///< of a state that has converged
  SlipWork slip;             ///< since friction has started
};

/// Starts friction at this state, with its contacts and the memory of the last increment. Slip
/// counts from here until the next start. Returns the work that the springs of contacts hold.
SlipWork start_friction(PackingModel& model, const RodState& rod, const Observation& observed,
                        std::span<const SlipMemory> memory);

/// What is done at an equilibrium that is a saddle.
enum class Saddles { escape, accept };

/// Brings `rod`, fed from the equilibrium `before`, to a minimum. Repeats the minimization until no
/// new contact joins: with friction, contacts that form on the way rub from where they came into
/// touch. Where saddles are accepted none is looked for, and `report.stable` tells nothing.
Equilibrium equilibrate(PackingModel& model, const RodState& before, RodState& rod,
                        Saddles saddles = Saddles::escape);

}  // namespace wirepack
