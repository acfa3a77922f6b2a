#pragma once

#include <gtest/gtest.h>

#include "wirepack/core/random.hpp"
#include "wirepack/solve/gradient_check.hpp"

namespace wirepack::testing {

/// Central differences of 1e-6: rounding 1e-10 / 1e-6.
inline constexpr double gradient_tolerance = 1e-7;

inline Eigen::VectorXd small_offset(const RodState& state, std::uint64_t seed) {
  const FrameChart chart(state, HeldUnknowns::none(state));
  Random random(seed);
  Eigen::VectorXd offset(chart.size());
  for (double& v : offset) v = 0.1 * random.symmetric();
  return offset;
}

/// The gradient of a term is that of its differences, and some derivative is larger than `least`.
template <EnergyTerm Term>
void expect_exact_gradient(const RodState& state, Term& term, const Eigen::VectorXd& offset,
                           double least = 1e-3) {
  const GradientCheck check =
      check_gradient(state, HeldUnknowns::none(state), EnergyTerms{term}, offset, 1e-6);
  EXPECT_GT(check.largest_derivative, least);
  EXPECT_LT(check.relative_error, gradient_tolerance);
}

template <EnergyTerm Term>
void expect_exact_gradient(const RodState& state, Term& term) {
  expect_exact_gradient(state, term, small_offset(state, 7));
}

template <EnergyTerm Term>
void expect_exact_inlet_derivative(const RodState& state, Term& term) {
  const GradientCheck check = check_inlet_derivative(state, EnergyTerms{term}, 1e-6);
  EXPECT_GT(check.largest_derivative, 1e-4);
  EXPECT_LT(check.relative_error, 1e-6);  // one number, so no larger one hides its rounding
}

}  // namespace wirepack::testing
