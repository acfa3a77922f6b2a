#include "wirepack/energy/energy_terms.hpp"

namespace wirepack {

bool EnergyTerms::prepare(const RodState& state) const {
  bool done = false;
  for (const EnergyTermRef& term : terms_) done |= term.prepare(state);
  return done;
}

Energy EnergyTerms::add_gradient(const RodState& state, Gradient& gradient) const {
  Energy sum;
  for (const EnergyTermRef& term : terms_) sum += term.add_gradient(state, gradient);
  return sum;
}

void EnergyTerms::add_curvature(const RodState& state, CurvatureModel& model) const {
  for (const EnergyTermRef& term : terms_) term.add_curvature(state, model);
}

std::vector<NamedEnergy> EnergyTerms::breakdown(const RodState& state, Gradient& gradient) const {
  std::vector<NamedEnergy> energies;
  for (const EnergyTermRef& term : terms_) {
    energies.push_back({term.name(), term.add_gradient(state, gradient)});
  }
  return energies;
}

}  // namespace wirepack
