#pragma once

#include <optional>

#include "wirepack/packing/packing_model.hpp"
#include "wirepack/packing/packing_progress.hpp"
#include "wirepack/packing/stop_rule.hpp"

namespace wirepack {

// An increment that was tried. The progress that it started from stays as it was. The model keeps
// the trial's contacts with friction, which the next start of friction replaces, and neighbor
// lists.
struct Trial {
  PackingProgress progress;           // after the increment; useless where it failed
  std::optional<StopReason> failure;  // no equilibrium was found, or strands passed
  bool resolved = true;               // false: only a shorter increment tells what happened
  SolverWork work;
};

// One increment of at most `longest` times the configured length, in five stages: split the inlet
// edge, feed, equilibrate, account for the work, record the row.
Trial attempt_increment(PackingModel& model, const PackingProgress& from, double longest);

// Rest length of the inlet edge at which whole edges are fed.
double inlet_at_start(const RodParams& wire);

}  // namespace wirepack
