#include "wirepack/packing/quasistatic_packing.hpp"

#include <algorithm>

#include "wirepack/core/error.hpp"
#include "wirepack/packing/equilibrate.hpp"

#include "increment.hpp"

namespace wirepack {

namespace {

// An increment whose work is not known well enough is halved, down to this part.
constexpr double resolving_substep = 1.0 / 8;

}  // namespace

QuasistaticPacking::QuasistaticPacking(const Scenario& scenario, const EnergyTerms& extra)
    : QuasistaticPacking(scenario, PackingProgress{}, extra) {
  progress_.rod = initial_wire(model_->nozzle, model_->wire, inlet_at_start(model_->wire));
  progress_.random_state = scenario.seed;
  const EquilibriumReport start = minimize(*model_, progress_.rod);
  if (start.end != EquilibriumEnd::converged) {
    throw NumericalFailure("the first two edges in the nozzle do not come to rest");
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
  std::int64_t evaluations = 0;
  while (true) {
    Trial trial = attempt_increment(*model_, progress_, progress_.substep);
    evaluations += trial.work.evaluations;
    progress_.work += trial.work;
    const bool unresolved = !trial.resolved && progress_.substep > resolving_substep;
    if (!trial.failure && !unresolved) {
      trial.progress.last.evaluations = static_cast<double>(evaluations);
      trial.progress.work = progress_.work;
      trial.progress.substep = std::min(1.0, 2 * trial.progress.substep);
      progress_ = std::move(trial.progress);
      return {progress_.last, reached_limit(model_->scenario, progress_)};
    }
    if (progress_.substep <= smallest_substep) return {std::nullopt, trial.failure};
    progress_.substep /= 2;
    if (trial.failure) ++progress_.rollbacks;
  }
}

bool QuasistaticPacking::frame_is_due() const {
  return wirepack::frame_is_due(model_->scenario, progress_);
}

PackingFrame QuasistaticPacking::take_frame() { return wirepack::take_frame(*model_, progress_); }

}  // namespace wirepack
