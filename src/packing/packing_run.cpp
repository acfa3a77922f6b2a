#include "wirepack/packing/packing_run.hpp"

#include <utility>

namespace wirepack {

namespace {

template <class... Progress>
std::variant<QuasistaticPacking, DynamicPacking> packing_of(const Scenario& scenario,
                                                            Progress&&... progress) {
  require_valid(scenario);  // which names problems in the units of the user
  const Scenario own = in_own_units(scenario);
  if (own.method == Method::dynamic) {
    return DynamicPacking(own, std::forward<Progress>(progress)...);
  }
  return QuasistaticPacking(own, std::forward<Progress>(progress)...);
}

}  // namespace

PackingRun::PackingRun(const Scenario& scenario)
    : units_(units_of(scenario)), run_(packing_of(scenario)) {}

PackingRun::PackingRun(const Scenario& scenario, PackingProgress progress)
    : units_(units_of(scenario)), run_(packing_of(scenario, std::move(progress))) {}

Advance PackingRun::advance() {
  try {
    Advance step = std::visit([](auto& run) { return run.advance(); }, run_);
    if (step.row) step.row = in_units(*step.row, units_);
    return step;
  } catch (const UnstableIntegration& end) {
    throw UnstableIntegration(end.increment(), end.inserted_length() * units_.length,
                              end.time_step() * units_.time());
  }
}

}  // namespace wirepack
