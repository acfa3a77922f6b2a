#include "wirepack/solve/gradient_check.hpp"

namespace wirepack {

namespace {

double energy_at(const RodState& state, const EnergyFunctions& energy) {
  Gradient unused;
  set_zero(unused, state);
  energy.prepare(state);
  return energy.add_gradient(state, unused);
}

}  // namespace

GradientCheck check_gradient(const RodState& state, const HeldUnknowns& held,
                             const EnergyFunctions& energy, const Eigen::VectorXd& offset,
                             double difference) {
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
    x[k] = x0[k] + difference;
    chart.set_state(x, moved);
    const double above = energy_at(moved, energy);
    x[k] = x0[k] - difference;
    chart.set_state(x, moved);
    numeric[k] = (above - energy_at(moved, energy)) / (2 * difference);
  }
  const double largest = analytic.cwiseAbs().maxCoeff();
  return {largest, (analytic - numeric).cwiseAbs().maxCoeff() / largest};
}

GradientCheck check_inlet_derivative(const RodState& state, const EnergyFunctions& energy,
                                     double difference) {
  Gradient gradient;
  set_zero(gradient, state);
  energy.prepare(state);
  energy.add_gradient(state, gradient);
  RodState longer = state, shorter = state;
  longer.inlet_rest_length += difference;
  shorter.inlet_rest_length -= difference;
  const double numeric =
      (energy_at(longer, energy) - energy_at(shorter, energy)) / (2 * difference);
  const double analytic = gradient.inlet_length;
  return {std::abs(analytic), std::abs(analytic - numeric) / std::abs(analytic)};
}

}  // namespace wirepack
