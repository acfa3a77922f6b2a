#include "wirepack/solve/equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "wirepack/core/error.hpp"
#include "wirepack/solve/minimizer.hpp"
#include "wirepack/solve/preconditioner.hpp"

namespace wirepack {

namespace {

// The lowest point seen; points equal in energy to round-off are ranked by their residual.
struct Best {
  RodState state;
  double energy = HUGE_VAL;
  double residual = HUGE_VAL;
  double inlet_length_force = 0;

  bool improved_by(double new_energy, double new_residual) const {
    if (!std::isfinite(new_energy)) return false;
    const double noise = 1e-13 * std::abs(energy);
    if (energy == HUGE_VAL || new_energy < energy - noise) return true;
    return new_energy <= energy + noise && new_residual < residual;
  }
};

// Tolerance of each unknown, so that a residual is one number.
Eigen::VectorXd inverse_tolerances(const FrameChart& chart, const EquilibriumOptions& options) {
  Eigen::VectorXd result(chart.size());
  for (Index b = 0; b < chart.block_count(); ++b) {
    for (int c = 0; c < 4; ++c) {
      const Index u = chart.unknown(b, c);
      if (u >= 0) result[u] = 1 / (c < 3 ? options.force_tolerance : options.moment_tolerance);
    }
  }
  return result;
}

// One round: one chart, one factor.
DescentReport descend_once(Best& best, const HeldUnknowns& held, const EnergyFunctions& energy,
                           const EquilibriumOptions& options, int max_evaluations) {
  const FrameChart chart(best.state, held);
  CurvatureModel model(chart);
  energy.prepare(chart.reference());
  energy.add_curvature(chart.reference(), model);
  Preconditioner preconditioner(model.lower_triangle(options.shift));

  const Eigen::VectorXd x0 = chart.unknowns();
  const Eigen::VectorXd inverse_tolerance = inverse_tolerances(chart, options);
  RodState state = chart.reference();
  Gradient gradient;
  Eigen::VectorXd step, by_x;
  const Objective objective = [&](const Eigen::VectorXd& y, Eigen::VectorXd& by_y) {
    preconditioner.to_step(y, step);
    step += x0;
    chart.set_state(step, state);
    set_zero(gradient, state);
    energy.prepare(state);
    const double value = energy.add_gradient(state, gradient);
    chart.pull_back(state, gradient.node, gradient.frame, by_x);
    const double residual = by_x.cwiseProduct(inverse_tolerance).cwiseAbs().maxCoeff();
    if (best.improved_by(value, residual)) {
      best.state = state;
      best.energy = value;
      best.residual = residual;
      best.inlet_length_force = gradient.inlet_length;
    }
    const bool at_rest = residual <= 1 && best.energy == value;
    preconditioner.to_gradient(by_x, by_y);
    return Evaluation{value, at_rest};
  };
  return descend(objective, Eigen::VectorXd::Zero(chart.size()),
                 {max_evaluations, options.method.memory});
}

}  // namespace

EquilibriumReport solve_equilibrium(RodState& state, const HeldUnknowns& held,
                                    const EnergyFunctions& energy,
                                    const EquilibriumOptions& options) {
  Best best;
  best.state = state;
  EquilibriumReport report;
  int fruitless_rounds = 0;
  while (true) {
    const double energy_before = best.energy;
    const double residual_before = best.residual;
    const int left = options.method.max_evaluations - report.evaluations;
    const DescentReport round =
        descend_once(best, held, energy, options, std::min(options.method.refactor_every, left));
    report.evaluations += round.evaluations;
    ++report.factorizations;
    if (best.energy == HUGE_VAL) throw NumericalFailure("the start has no finite energy");
    if (best.residual <= 1) {
      report.end = EquilibriumEnd::converged;
      break;
    }
    if (report.evaluations >= options.method.max_evaluations) {
      report.end = EquilibriumEnd::evaluation_limit;
      break;
    }
    const bool progress = best.energy < energy_before - 1e-12 * std::abs(best.energy) ||
                          best.residual < 0.9 * residual_before;
    fruitless_rounds = progress ? 0 : fruitless_rounds + 1;
    if (fruitless_rounds == 3) {
      report.end = EquilibriumEnd::stalled;
      break;
    }
  }
  state = std::move(best.state);
  report.energy = best.energy;
  report.residual = best.residual;
  report.inlet_length_force = best.inlet_length_force;
  return report;
}

}  // namespace wirepack
