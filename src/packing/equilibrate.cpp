#include "wirepack/packing/equilibrate.hpp"

#include <utility>

#include "wirepack/solve/stability.hpp"

namespace wirepack {

namespace {

// A wire that slides along itself slips by the fed length. A new contact was missed if its slip
// exceeds that by more than this, over the wire radius.
constexpr double missed_slip = 0.25;

SlipPotential::Joined join_friction(PackingModel& model, const RodState& before,
                                    const RodState& rod, const Observation& observed) {
  if (!model.has_friction()) return {};
  const double usual_slip =
      missed_slip * model.wire.radius + rod.inlet_rest_length - before.inlet_rest_length;
  return model.friction.join(before, rod, observed.contacts, observed.wall_forces, usual_slip);
}

}  // namespace

SlipWork start_friction(PackingModel& model, const RodState& rod, const Observation& observed,
                        std::span<const SlipMemory> memory) {
  if (!model.has_friction()) return {};
  model.friction.start(rod, observed.contacts, observed.wall_forces, memory);
  return model.friction.work(rod);
}

Equilibrium equilibrate(PackingModel& model, const RodState& before, RodState& rod,
                        Saddles saddles) {
  const RodState fed = rod;
  Equilibrium found;
  SolverWork work;
  // Minimizes once and observes the state; false if it has not converged.
  const auto settle = [&] {
    found.report = minimize(model, rod);
    found.report.work += work;
    work = found.report.work;
    if (found.report.end != EquilibriumEnd::converged) return false;
    found.observed = observe(model, rod);
    return true;
  };
  bool repeated = false;
  int saddles_met = 0;
  while (settle()) {
    const auto joined = join_friction(model, before, rod, found.observed);
    if (joined.count > 0) {
      if (repeated || !joined.missed) continue;
      // No friction acted on this contact while it formed, so it slid off and its present force
      // means nothing. It is glued where it formed until its normal force is known, and then it
      // rubs with that force.
      repeated = true;
      rod = fed;
      model.friction.hold_joined(joined.count);
      if (!settle()) break;
      model.friction.release_joined(joined.count, found.observed.contacts,
                                    found.observed.wall_forces);
      continue;
    }
    if (saddles == Saddles::accept) break;
    if (saddles_met++ == most_saddles) {
      found.report.stable = false;  // this one is not tested, and counts as a saddle
      break;
    }
    if (!escape_saddle(model, rod, found.report)) break;
    work = found.report.work;
  }
  found.slip = model.friction.work(rod);
  found.report.energy -= found.slip.stored + found.slip.dissipated;
  return found;
}

}  // namespace wirepack
