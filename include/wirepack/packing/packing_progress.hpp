#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "wirepack/dynamics/equation_of_motion.hpp"
#include "wirepack/dynamics/gear_values.hpp"
#include "wirepack/energy/slip_potential.hpp"
#include "wirepack/packing/mean_force.hpp"
#include "wirepack/packing/work_balance.hpp"
#include "wirepack/rod/rod_state.hpp"
#include "wirepack/solve/solver_work.hpp"

namespace wirepack {

/// Density at which the mean force over an edge length first reached a level. phi_max at any
/// threshold can be read from it afterwards. Levels are decades and half-decades (1, sqrt(10), 10,
/// ...).
struct ForceCrossing {
  double level;
  double packing_density;
};

/// What a run with inertia needs beside its rod to continue.
struct MotionProgress {
  GearValues nodes, spins;  ///< see DynamicState
  double time = 0;
  FrictionMemory friction;
  EnergyFlow flow;  ///< at the last step
  double step = 0;  ///< of time, that of the GearValues; 0: unknown, one step all the time
};

/// Everything a run needs to continue, bit for bit, from the last accepted increment. Units are
/// those that the run is computed in: of its own wire in a PackingRun and in result files (see
/// in_own_units).
struct PackingProgress {
  RodState rod;
  HistoryRow last;  ///< of the last accepted increment; zeros at the start
  WorkBalance balance;
  std::uint64_t random_state = 0;       ///< of the perturbations
  std::vector<SlipMemory> slip_memory;  ///< of the contacts with friction
  double substep = 1;                   ///< part of an increment that is tried next, 2^-k
  WorkErrors work_errors;
  std::vector<ForceReading> recent_forces;  ///< for their mean over an edge length
  double last_frame_density = -1;
  std::vector<ForceCrossing> scaled_crossings;    ///< of F R^2 / YI
  std::vector<ForceCrossing> absolute_crossings;  ///< of F / (Y a^2)
  std::int64_t snaps = 0;
  std::int64_t rollbacks = 0;  ///< increments halved after a failure, and rounds taken back
  SolverWork work;             ///< of all increments, those that were repeated included
  std::optional<MotionProgress> motion;  ///< of a run with inertia
};

}  // namespace wirepack
