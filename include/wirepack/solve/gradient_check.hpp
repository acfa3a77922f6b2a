#pragma once

#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/rod/frame_chart.hpp"

namespace wirepack {

/// Analytic derivative against central differences.
struct GradientCheck {
  double largest_derivative;  ///< so that a test can refuse to pass on an energy that is flat
  double relative_error;      ///< largest difference over largest_derivative
};

/// In all unknowns of a chart of `state`, taken at a point away from the chart's reference by
/// `offset` (one number per unknown), so that the terms of a moved chart are checked too.
GradientCheck check_gradient(const RodState& state, const HeldUnknowns& held,
                             const EnergyTerms& energy, const Eigen::VectorXd& offset,
                             double spacing);

/// By the inlet rest length at fixed unknowns: the injection force.
GradientCheck check_inlet_derivative(const RodState& state, const EnergyTerms& energy,
                                     double spacing);

}  // namespace wirepack
