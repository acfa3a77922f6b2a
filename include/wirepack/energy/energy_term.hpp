#pragma once

#include <concepts>
#include <string_view>

#include "wirepack/core/energy.hpp"
#include "wirepack/energy/curvature_model.hpp"
#include "wirepack/energy/gradient.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// An energy of a state. `add_gradient` returns the energy (with the round-off of its sum, or a
/// plain number) and adds its exact derivatives, the explicit one by the inlet rest length
/// included; `add_curvature` adds a model of the second derivative, positive semidefinite where its
/// exactness is 0. A term sees no solver and no unknowns. A new term comes with: a closed form, a
/// gradient check against differences, and invariance under rigid motion.
template <class T>
concept EnergyTerm = requires(const T& term, const RodState& state, Gradient& gradient,
                              CurvatureModel& model) {
  { T::name } -> std::convertible_to<std::string_view>;
  { term.add_gradient(state, gradient) } -> std::convertible_to<Energy>;
  term.add_curvature(state, model);
};

/// A term that keeps something it finds out about states (a neighbor list) brings it up to date
/// here, before it is evaluated, and says whether there was something to do. This may change the
/// cost of an evaluation, never its value.
template <class T>
concept PreparedTerm = requires(T& term, const RodState& state) {
  { term.prepare(state) } -> std::same_as<bool>;
};

}  // namespace wirepack
