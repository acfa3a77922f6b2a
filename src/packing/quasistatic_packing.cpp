#include "wirepack/packing/quasistatic_packing.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "wirepack/core/error.hpp"
#include "wirepack/packing/equilibrate.hpp"

#include "increment.hpp"

namespace wirepack {

namespace {

// An increment whose work is not known well enough is halved, down to this part.
constexpr double resolving_substep = 1.0 / 8;

constexpr double rounding = 1e-9;  // relative, of a part of an increment

// The part to try after one that failed. The trial may have ended early, at a phase of the mesh or
// the end of the run, so this halves until the next one is really shorter.
double less_than(double tried, double substep) {
  do {
    substep /= 2;
  } while (substep > smallest_substep && substep > tried * (1 - rounding));
  return substep;
}

}  // namespace

QuasistaticPacking::QuasistaticPacking(const Scenario& scenario, const EnergyTerms& extra)
    : QuasistaticPacking(scenario, PackingProgress{}, extra) {
  progress_.rod = initial_wire(model_->nozzle, model_->wire, inlet_at_start(model_->wire));
  progress_.random_state = scenario.seed;
  const EquilibriumReport start = minimize(*model_, progress_.rod);
  if (start.end != EquilibriumEnd::converged) {
    throw NumericalFailure("the first two edges in the nozzle have no equilibrium");
  }
  progress_.last = row_of(*model_, progress_.rod, observe(*model_, progress_.rod));
  progress_.last.energy_total = start.energy;
  progress_.last.force = start.inlet_length_force;
  progress_.balance.work = start.energy;
  progress_.work = start.work;
}

QuasistaticPacking::QuasistaticPacking(const Scenario& scenario, PackingProgress progress,
                                       const EnergyTerms& extra)
    : model_(std::make_unique<PackingModel>(scenario, extra)), progress_(std::move(progress)) {}

QuasistaticPacking::~QuasistaticPacking() = default;
QuasistaticPacking::QuasistaticPacking(QuasistaticPacking&&) noexcept = default;

Advance QuasistaticPacking::advance() {
  FeedStart start = ready_to_feed(*model_, progress_);
  PackingProgress& from = start.split.progress;
  SolverWork work = start.split.work;
  std::optional<StopReason> failure = start.split.failure;
  while (!failure) {
    Trial trial = attempt_increment(*model_, start, from.substep);
    work += trial.work;
    const bool unresolved = !trial.resolved && trial.part > resolving_substep * (1 + rounding);
    if (!trial.failure && !unresolved) {
      work += progress_.work;
      progress_ = std::move(trial.progress);
      progress_.last.evaluations = static_cast<double>(work.evaluations - from.work.evaluations);
      progress_.work = work;
      progress_.substep = std::min(1.0, 2 * from.substep);
      return {progress_.last, reached_limit(model_->scenario, progress_)};
    }
    if (from.substep <= smallest_substep || trial.part <= smallest_substep) {
      failure = trial.failure;
    } else {
      from.substep = less_than(trial.part, from.substep);
      // a trial that is repeated teaches only how far off whole edges are
      from.work_errors.edge_scatter = trial.progress.work_errors.edge_scatter;
      if (trial.failure) ++from.rollbacks;
    }
  }
  progress_.work += work;
  progress_.substep = from.substep;
  progress_.rollbacks = from.rollbacks;
  return {std::nullopt, failure};
}

bool QuasistaticPacking::frame_is_due() const {
  return wirepack::frame_is_due(model_->scenario, progress_);
}

PackingFrame QuasistaticPacking::take_frame() { return wirepack::take_frame(*model_, progress_); }

}  // namespace wirepack
