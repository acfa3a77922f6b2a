#include "increment.hpp"

#include <algorithm>
#include <cmath>

#include "wirepack/core/random.hpp"
#include "wirepack/feed/feeder.hpp"
#include "wirepack/packing/equilibrate.hpp"
#include "wirepack/packing/observation.hpp"
#include "wirepack/packing/stop_rule.hpp"

namespace wirepack {

namespace {

// The discretization error of the energy at the inlet edge grows with the cube of the edge's
// length, so the edge is split early. The force then has nearly the same mean over a cycle as the
// change of energy. Where moments are linear at the clamp, the force of an inlet edge x l is too
// low by YI kappa'^2 l^2 x^2 / 4. The mean change of energy per length is too low by
// YI kappa'^2 l^2 / 12, so both agree at x = 0.58.
constexpr double longest_inlet = 1.1;
// A short edge that presses on strands can be too stiff for an equilibrium to be found. The split
// may then wait until the edge is so long.
constexpr double latest_split = 1.5;
constexpr double inlet_of_whole_edges = 0.6;

bool is_whole_edge(double length, const RodParams& wire) {
  return std::abs(length - wire.edge_length) < 1e-9 * wire.edge_length;
}

// True if an edge is a whole number of increments.
bool divides_edges(double increment, const RodParams& wire) {
  const double count = wire.edge_length / increment;
  return std::abs(count - std::round(count)) < 1e-9 * count;
}

// True if the wire slides along itself by this length: it is a whole edge, as increments are, and
// there is no friction, which would have to undo the slide where it holds the wire.
bool slides(const PackingModel& model, double length) {
  return is_whole_edge(model.scenario.insertion.increment, model.wire) && !model.has_friction() &&
         is_whole_edge(length, model.wire);
}

std::optional<StopReason> failure_of(const EquilibriumReport& report) {
  switch (report.end) {
    case EquilibriumEnd::converged:
      return std::nullopt;
    case EquilibriumEnd::inadmissible:
      return StopReason::strands_passed;
    case EquilibriumEnd::evaluation_limit:
    case EquilibriumEnd::stalled:
      break;
  }
  return StopReason::no_equilibrium;
}

// What an increment has fed.
struct Fed {
  double length;
  bool whole_edge;
};

double length_of_increment(const PackingModel& model, const PackingProgress& from, double part) {
  const Scenario& scenario = model.scenario;
  double length = length_within_limits(scenario, from.last.inserted_length,
                                       scenario.insertion.increment * part);
  if (divides_edges(scenario.insertion.increment, model.wire)) {
    // A part of an increment ends at the next phase of the mesh at which whole increments end, or
    // before: other phases read another mean force.
    const double whole = scenario.insertion.increment;
    const double increments = (from.rod.inlet_rest_length - inlet_at_start(model.wire)) / whole;
    const double missing = whole * (std::ceil(increments - 1e-9) - increments);
    if (missing > 1e-9 * whole) length = std::min(length, missing);
  }
  if (slides(model, length) &&
      !whole_edge_is_likely_resolved(length, from.last.force, force_unit(scenario), from.balance,
                                     from.work_errors)) {
    length /= 2;
  }
  return length;
}

// Finds the equilibrium. Friction has started at `before`. Books evaluations, failure and the work
// against friction in the trial.
Equilibrium find_equilibrium(PackingModel& model, const RodState& before, const SlipWork& at_start,
                             Saddles saddles, Trial& trial) {
  PackingProgress& next = trial.progress;
  const Equilibrium found = equilibrate(model, before, next.rod, saddles);
  trial.work += found.report.work;
  next.rollbacks += found.report.work.rounds_taken_back;
  trial.failure = failure_of(found.report);
  if (trial.failure || !model.has_friction()) return found;
  next.slip_memory = model.friction.memory(next.rod);
  next.balance.friction += found.slip.dissipated;
  next.balance.contact_springs += found.slip.stored - at_start.stored;
  return found;
}

// Work against friction: dissipated, or stored in the contacts.
double against_friction(const Equilibrium& found, const SlipWork& at_start) {
  return found.slip.dissipated + found.slip.stored - at_start.stored;
}

SlipWork start_friction(PackingModel& model, const PackingProgress& progress) {
  if (!model.has_friction()) return {};
  return start_friction(model, progress.rod, observe(model, progress.rod), progress.slip_memory);
}

// Moves the nodes at random until the first coil has formed, off the straight wire, which is a
// saddle under compression.
void perturb(const PackingModel& model, PackingProgress& next) {
  RodState& rod = next.rod;
  if (total_rest_length(rod, model.wire) > first_coil_length(model.scenario.cavity)) return;
  Random random(next.random_state);
  const double amplitude = model.scenario.insertion.perturbation * model.wire.radius;
  const FrameChart chart(rod, HeldUnknowns::none(rod));
  Eigen::VectorXd x = chart.unknowns();
  for (Index i = 0; i + 1 < rod.node_count(); ++i) {
    for (int c = 0; c < 3; ++c) x[chart.unknown(i, c)] += amplitude * random.symmetric();
  }
  chart.set_state(x, rod);
  next.random_state = random.state();
}

// Feeds wire: the inlet edge grows; or the wire slides along itself, if whole edges are fed without
// friction.
Fed feed(PackingModel& model, double length, Trial& trial) {
  perturb(model, trial.progress);
  const bool whole_edge = slides(model, length);
  if (whole_edge) {
    slide_one_edge(trial.progress.rod, model.wire);
    trial.work += settle_tip(model, trial.progress.rod);
  } else {
    insert(trial.progress.rod, length);
  }
  return {length, whole_edge};
}

// Compares the work of the force with what the increment has spent. What is missing was released by
// a snap, or is an error.
WorkBooking account(const PackingModel& model, const FeedStart& start, const Fed& fed, double force,
                    double spent, Trial& trial) {
  PackingProgress& next = trial.progress;
  const WorkBooking booking =
      book({fed.length, start.force, force, spent, force_unit(model.scenario), fed.whole_edge},
           next.balance, next.work_errors);
  trial.resolved = booking.resolved;
  return booking;
}

HistoryRow record(const PackingModel& model, const PackingProgress& next,
                  const Equilibrium& found) {
  HistoryRow row = row_of(model, next.rod, found.observed);
  row.increment = next.last.increment + 1;
  row.energy_total = found.report.energy;
  row.force = found.report.inlet_length_force;
  row.scaled_force = row.force / force_unit(model.scenario);
  row.residual = found.report.residual * model.scenario.minimizer.tolerance;
  row.stable = found.report.stable ? 1 : 0;
  row.wall_seconds = next.last.wall_seconds;
  return row;
}

}  // namespace

double inlet_at_start(const RodParams& wire) { return inlet_of_whole_edges * wire.edge_length; }

// If no equilibrium is found with the new short edge, the split is undone and waits until the edge
// is longer. From `latest_split` on it must succeed.
FeedStart ready_to_feed(PackingModel& model, const PackingProgress& from) {
  FeedStart start{{from, std::nullopt, true, 0, {}}, from.last.energy_total, from.last.force};
  if (!split_is_due(from.rod, longest_inlet * model.wire.edge_length)) return start;
  PackingProgress& next = start.split.progress;
  split_inlet(next.rod, model.nozzle, model.wire);
  const RodState before = next.rod;
  const SlipWork at_start = start_friction(model, next);
  // no increment ends here, so whether this is a saddle is left to the next equilibrium
  const Equilibrium found = find_equilibrium(model, before, at_start, Saddles::accept, start.split);
  if (start.split.failure) {
    if (split_is_due(from.rod, latest_split * model.wire.edge_length)) return start;
    next = from;
    start.split.failure.reset();
    return start;
  }
  const double taken = start.energy - found.report.energy - against_friction(found, at_start);
  const double edge_work =
      model.wire.edge_length * std::max(std::abs(start.force), force_unit(model.scenario));
  start.released = book_split(taken, edge_work, next.balance);
  start.energy = found.report.energy;
  start.force = found.report.inlet_length_force;
  start.dissipated = found.slip.dissipated;
  return start;
}

Trial attempt_increment(PackingModel& model, const FeedStart& start, double longest_part) {
  const PackingProgress& from = start.split.progress;
  const double length = length_of_increment(model, from, longest_part);
  Trial trial{from, std::nullopt, true, length / model.scenario.insertion.increment, {}};
  PackingProgress& next = trial.progress;

  const RodState before = next.rod;
  const SlipWork at_start = start_friction(model, next);
  const Fed fed = feed(model, length, trial);
  const Equilibrium found = find_equilibrium(model, before, at_start, Saddles::escape, trial);
  if (trial.failure) return trial;

  HistoryRow row = record(model, next, found);
  const double spent = found.report.energy - start.energy + against_friction(found, at_start);
  row.force_difference = spent / fed.length;
  row.friction_dissipation = start.dissipated + found.slip.dissipated;
  const WorkBooking booking = account(model, start, fed, row.force, spent, trial);
  row.snap_energy = booking.released + start.released;
  if (row.snap_energy > 0) ++next.snaps;
  next.last = row;
  note_force(model.scenario, next);
  return trial;
}

}  // namespace wirepack
