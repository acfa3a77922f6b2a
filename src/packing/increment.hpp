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
  double part = 0;                    // of the configured increment, that was fed
  SolverWork work;
};

// The equilibrium that the wire is fed from, and what a split of the inlet edge has changed on the
// way to it.
struct FeedStart {
  Trial split;            // the progress without a split, where none was due
  double energy, force;   // of the equilibrium
  double dissipated = 0;  // by friction, while the wire gave way to the split
  double released = 0;    // by a snap that the split set off
};

// Splits the inlet edge if it has grown long. Increments that are tried one after the other start
// from one split.
FeedStart ready_to_feed(PackingModel& model, const PackingProgress& from);

// One increment of at most `longest_part` times the configured length, in four stages: feed,
// equilibrate, account for the work, record the row.
Trial attempt_increment(PackingModel& model, const FeedStart& start, double longest_part);

// Rest length of the inlet edge at which whole edges are fed.
double inlet_at_start(const RodParams& wire);

}  // namespace wirepack
