#pragma once

#include <functional>
#include <tuple>

#include "wirepack/energy/energy_term.hpp"

namespace wirepack {

/// Sum of terms, held by reference; itself an energy term.
template <EnergyTerm... Terms>
class TotalEnergy {
 public:
  static constexpr std::string_view name = "total";
  explicit TotalEnergy(Terms&... terms) : terms_(terms...) {}

  bool prepare(const RodState& state) {
    return std::apply([&](auto&... term) { return (false | ... | prepare_one(term, state)); },
                      terms_);
  }
  double add_gradient(const RodState& state, Gradient& gradient) const {
    return std::apply(
        [&](const auto&... term) { return (0.0 + ... + term.add_gradient(state, gradient)); },
        terms_);
  }
  void add_curvature(const RodState& state, CurvatureModel& model) const {
    std::apply([&](const auto&... term) { (term.add_curvature(state, model), ...); }, terms_);
  }

 private:
  template <class Term>
  static bool prepare_one(Term& term, const RodState& state) {
    if constexpr (PreparedTerm<Term>) return term.prepare(state);
    return false;
  }
  std::tuple<Terms&...> terms_;
};

/// A total energy behind three calls, for code that is compiled once. Refers to the energy.
struct EnergyFunctions {
  std::function<bool(const RodState&)> prepare;
  std::function<double(const RodState&, Gradient&)> add_gradient;
  std::function<void(const RodState&, CurvatureModel&)> add_curvature;
};

template <EnergyTerm Energy>
EnergyFunctions functions_of(Energy& energy) {
  EnergyFunctions f;
  f.prepare = [&energy](const RodState& state) {
    if constexpr (PreparedTerm<Energy>) return energy.prepare(state);
    return false;
  };
  f.add_gradient = [&energy](const RodState& state, Gradient& gradient) {
    return energy.add_gradient(state, gradient);
  };
  f.add_curvature = [&energy](const RodState& state, CurvatureModel& model) {
    energy.add_curvature(state, model);
  };
  return f;
}

}  // namespace wirepack
