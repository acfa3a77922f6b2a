#include "wirepack/packing/quasistatic_packing.hpp"

#include <algorithm>
#include <cmath>

#include "wirepack/core/error.hpp"
#include "wirepack/core/random.hpp"
#include "wirepack/feed/feeder.hpp"
#include "wirepack/observe/packing_density.hpp"
#include "wirepack/packing/imperfection.hpp"
#include "wirepack/packing/observation.hpp"

#include "quasistatic_model.hpp"

namespace wirepack {

namespace {

// An increment is taken in halves where it fails; a part this small that fails ends the run.
constexpr double smallest_substep = 1.0 / 64;
// Where its work is not known well enough, an increment is taken in halves down to this part.
constexpr double resolving_substep = 1.0 / 8;

// The inlet edge is split when it is a little longer than the others: what the mesh there gets wrong is
// of the order of its cube and goes with an edge that is short. The force then has the same mean over a
// cycle as the change of energy, and at 0.55 edge lengths it is that mean (moments that grow linearly
// from the clamp: it is wrong by YI kappa'^2 l^2 (x^2 / 12 + x / 18 - 1 / 72) for an inlet edge x l).
constexpr double longest_inlet = 1.1;
// A short edge that presses on strands can be too stiff to come to rest. The split may wait till then.
constexpr double latest_split = 1.5;
constexpr double inlet_of_whole_edges = 0.6;

bool is_whole_edge(double length, const RodParams& wire) {
  return std::abs(length - wire.edge_length) < 1e-9 * wire.edge_length;
}

// An edge is a whole number of increments.
bool divides_edges(double increment, const RodParams& wire) {
  const double count = wire.edge_length / increment;
  return std::abs(count - std::round(count)) < 1e-9 * count;
}

// Whether increments are whole edges, by which the wire slides along itself. Friction would have to
// undo that where it holds the wire.
bool feeds_whole_edges(const Scenario& scenario) {
  return is_whole_edge(scenario.insertion.increment, scenario.wire) &&
         scenario.friction.model == FrictionModel::none;
}

struct Rest {
  EquilibriumReport report;
  double against_friction;  // dissipated, and stored in contacts
};

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

// The straight wire is a saddle under compression; until the first coil has formed, every start is
// moved off it.
void perturb(const Scenario& scenario, RodState& rod, std::uint64_t& random_state) {
  if (total_rest_length(rod, scenario.wire) > first_coil_length(scenario.cavity)) return;
  Random random(random_state);
  const double amplitude = scenario.insertion.perturbation * scenario.wire.radius;
  const FrameChart chart(rod, HeldUnknowns::none(rod));
  Eigen::VectorXd x = chart.unknowns();
  for (Index i = 0; i + 1 < rod.node_count(); ++i) {
    for (int c = 0; c < 3; ++c) x[chart.unknown(i, c)] += amplitude * random.symmetric();
  }
  chart.set_state(x, rod);
  random_state = random.state();
}

}  // namespace

QuasistaticPacking::QuasistaticPacking(const Scenario& scenario)
    : QuasistaticPacking(scenario, PackingProgress{}) {
  progress_.rod = initial_wire(model_->nozzle, scenario_.wire,
                               inlet_of_whole_edges * scenario_.wire.edge_length);
  progress_.random_state = scenario_.seed;
  const EquilibriumReport start = relax(scenario_, *model_, progress_.rod);
  if (start.end != EquilibriumEnd::converged) {
    throw NumericalFailure("the first two edges in the nozzle do not come to rest");
  }
  progress_.last = observe(scenario_, model_->contact, progress_.rod);
  progress_.last.energy_total = start.energy;
  progress_.last.force = start.inlet_length_force;
  progress_.balance.work = start.energy;
  progress_.work = start.work;
}

QuasistaticPacking::QuasistaticPacking(const Scenario& scenario, PackingProgress progress)
    : scenario_(scenario), progress_(std::move(progress)) {
  require_valid(scenario);
  const DrawnSetup drawn = drawn_setup(scenario);
  scenario_.wire = drawn.wire;
  model_ = std::make_unique<QuasistaticModel>(scenario_, drawn.nozzle);
}

QuasistaticPacking::~QuasistaticPacking() = default;
QuasistaticPacking::QuasistaticPacking(QuasistaticPacking&&) noexcept = default;

double QuasistaticPacking::length_of_step() const {
  double step = scenario_.insertion.increment * progress_.substep;
  const double length = progress_.last.inserted_length;
  if (scenario_.stop.length) step = std::min(step, *scenario_.stop.length - length);
  if (scenario_.stop.density) {
    step = std::min(
        step, length_at_density(*scenario_.stop.density, scenario_.cavity, scenario_.wire.radius) -
                  length);
  }
  if (divides_edges(scenario_.insertion.increment, scenario_.wire)) {
    // Parts of an increment lead back to the phases of the mesh that whole ones have: others read
    // another mean force.
    const double whole = scenario_.insertion.increment;
    const double inlet = inlet_of_whole_edges * scenario_.wire.edge_length;
    const double increments = (progress_.rod.inlet_rest_length - inlet) / whole;
    const double missing = whole * (std::ceil(increments - 1e-9) - increments);
    if (missing > 1e-9 * whole) step = std::min(step, missing);
  }
  return step;
}

std::optional<StopReason> QuasistaticPacking::advance() {
  std::int64_t evaluations = 0;
  while (true) {
    PackingProgress next = progress_;
    const StepResult result = step(next);
    evaluations += result.work.evaluations;
    progress_.work += result.work;
    const bool unresolved = result.unresolved && progress_.substep > resolving_substep;
    if (!result.failure && !unresolved) {
      next.last.evaluations = static_cast<double>(evaluations);
      next.work = progress_.work;
      next.substep = std::min(1.0, 2 * next.substep);
      progress_ = std::move(next);
      return reached_limit(scenario_, progress_);
    }
    if (progress_.substep <= smallest_substep) return result.failure;
    progress_.substep /= 2;
    if (result.failure) ++progress_.rollbacks;
  }
}

QuasistaticPacking::StepResult QuasistaticPacking::step(PackingProgress& next) {
  StepResult result;
  RodState& rod = next.rod;
  double energy_before = next.last.energy_total;
  const double fed = length_of_step();
  const bool slides = feeds_whole_edges(scenario_) && is_whole_edge(fed, scenario_.wire);
  double force_before = next.last.force;
  double dissipated = 0, released_by_split = 0;
  // Goes to rest from where friction has started; what rest is left with is elastic energy alone.
  const auto relax_with_friction = [&](const RodState& before, const SlipWork& at_start) {
    EquilibriumReport rest;
    do {
      rest = relax(scenario_, *model_, rod);
      result.work += rest.work;
      next.rollbacks += rest.work.rounds_taken_back;
      result.failure = failure_of(rest);
    } while (!result.failure && join_friction(scenario_, *model_, before, rod) > 0);
    const SlipWork work = model_->friction.work(rod);
    rest.energy -= work.stored + work.dissipated;
    next.slip_memory = model_->friction.memory(rod);
    next.balance.friction += work.dissipated;
    next.balance.contact_springs += work.stored - at_start.stored;
    dissipated += work.dissipated;
    return Rest{rest, work.dissipated + work.stored - at_start.stored};
  };
  if (split_is_due(rod, longest_inlet * scenario_.wire.edge_length)) {
    const PackingProgress unsplit = next;
    split_inlet(rod, model_->nozzle, scenario_.wire);
    const RodState before = rod;
    const Rest split =
        relax_with_friction(before, start_friction(scenario_, *model_, rod, next.slip_memory));
    if (!result.failure) {
      released_by_split = book_split(
          energy_before - split.report.energy - split.against_friction,
          scenario_.wire.edge_length * std::max(std::abs(force_before), force_unit(scenario_)),
          next.balance);
      energy_before = split.report.energy;
      force_before = split.report.inlet_length_force;
    } else if (!split_is_due(unsplit.rod, latest_split * scenario_.wire.edge_length)) {
      next = unsplit;
      dissipated = 0;
    } else {
      return result;
    }
  }
  const RodState before = rod;
  const SlipWork at_start = start_friction(scenario_, *model_, rod, next.slip_memory);
  perturb(scenario_, rod, next.random_state);
  if (slides) {
    slide_one_edge(rod, scenario_.wire);
    result.work += settle_tip(scenario_, *model_, rod);
  } else {
    insert(rod, fed);
  }
  const auto [rest, against_friction] = relax_with_friction(before, at_start);
  if (result.failure) return result;
  HistoryRow row = observe(scenario_, model_->contact, rod);
  row.increment = next.last.increment + 1;
  row.energy_total = rest.energy;
  row.force = rest.inlet_length_force;
  row.force_difference = (rest.energy - energy_before + against_friction) / fed;
  row.scaled_force = row.force / force_unit(scenario_);
  row.residual = rest.residual * scenario_.minimizer.tolerance;
  row.wall_seconds = next.last.wall_seconds;
  row.friction_dissipation = dissipated;

  const WorkBooking booking =
      book({fed, force_before, row.force, rest.energy - energy_before + against_friction,
            force_unit(scenario_), slides},
           next.balance, next.work_errors);
  result.unresolved = !booking.resolved;
  row.snap_energy = booking.released + released_by_split;
  if (row.snap_energy > 0) ++next.snaps;
  next.last = row;
  note_force(scenario_, next);
  return result;
}

bool QuasistaticPacking::frame_is_due() const {
  return wirepack::frame_is_due(scenario_, progress_);
}

PackingFrame QuasistaticPacking::take_frame() {
  return wirepack::take_frame(scenario_, model_->contact, progress_);
}

}  // namespace wirepack
