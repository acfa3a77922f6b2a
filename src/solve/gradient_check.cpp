#include "wirepack/solve/gradient_check.hpp"

namespace wirepack {

namespace {

Energy energy_at(const RodState& state, const EnergyTerms& energy) {
  Gradient unused;
  set_zero(unused, state);
  energy.prepare(state);
  return energy.add_gradient(state, unused);
}

}  // namespace

GradientCheck check_gradient(const RodState& state, const HeldUnknowns& held,
                             const EnergyTerms& energy, const Eigen::VectorXd& offset,
                             double spacing) {
  const FrameChart chart(state, held);
  const Eigen::VectorXd x0 = chart.unknowns() + offset;
  RodState moved = chart.reference();
  chart.set_state(x0, moved);
  Gradient gradient;
  set_zero(gradient, moved);
  energy.prepare(moved);
  energy.add_gradient(moved, gradient);
  Eigen::VectorXd analytic;
  chart.pull_back(moved, gradient.node, gradient.frame, analytic);

  Eigen::VectorXd numeric(chart.size());
  for (Index k = 0; k < chart.size(); ++k) {
    Eigen::VectorXd x = x0;
    x[k] = x0[k] + spacing;
    chart.set_state(x, moved);
    const Energy above = energy_at(moved, energy);
    x[k] = x0[k] - spacing;
    chart.set_state(x, moved);
    numeric[k] = difference(above, energy_at(moved, energy)) / (2 * spacing);
  }
  const double largest = analytic.cwiseAbs().maxCoeff();
  return {largest, (analytic - numeric).cwiseAbs().maxCoeff() / largest};
}

GradientCheck check_inlet_derivative(const RodState& state, const EnergyTerms& energy,
                                     double spacing) {
  Gradient gradient;
  set_zero(gradient, state);
  energy.prepare(state);
  energy.add_gradient(state, gradient);
  RodState longer = state, shorter = state;
  longer.inlet_rest_length += spacing;
  shorter.inlet_rest_length -= spacing;
  const double numeric =
      difference(energy_at(longer, energy), energy_at(shorter, energy)) / (2 * spacing);
  const double analytic = gradient.inlet_length;
  return {std::abs(analytic), std::abs(analytic - numeric) / std::abs(analytic)};
}

}  // namespace wirepack
