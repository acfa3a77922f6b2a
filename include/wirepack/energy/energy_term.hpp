#pragma once

#include <concepts>
#include <string_view>

#include "wirepack/core/energy.hpp"
#include "wirepack/energy/curvature_model.hpp"
#include "wirepack/energy/gradient.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// An energy of a state. `add_gradient` returns the energy (with the round-off of its sum, or a
/// plain number). It adds the exact derivatives, also the explicit one by the inlet rest length.
/// `add_curvature` adds to the model of the Hessian; where the model's exactness is 0, it adds a
/// positive semidefinite part. A term sees no solver and no unknowns. A new term comes with: a
/// closed form, a gradient check against differences, and invariance under rigid motion.
template <class T>
concept EnergyTerm = requires(const T& term, const RodState& state, Gradient& gradient,
                              CurvatureModel& model) {
  { T::name } -> std::convertible_to<std::string_view>;
  { term.add_gradient(state, gradient) } -> std::convertible_to<Energy>;
  term.add_curvature(state, model);
};

/// A term that keeps data about states, such as a neighbor list. `prepare` brings them up to date
/// before an evaluation, and returns whether there was something to do. It may change the cost of
/// an evaluation, never its value.
template <class T>
concept PreparedTerm = requires(T& term, const RodState& state) {
  { term.prepare(state) } -> std::same_as<bool>;
};

}  // namespace wirepack
