#include "wirepack/solve/equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "wirepack/core/error.hpp"
#include "wirepack/core/rotation.hpp"
#include "wirepack/solve/minimizer.hpp"
#include "wirepack/solve/preconditioner.hpp"

namespace wirepack {

namespace {

// The lowest point seen; points equal in energy to round-off are ranked by their residual.
struct Best {
  RodState state;
  double energy = HUGE_VAL;
  double residual = HUGE_VAL;
  double guarded = 0;  // part of the energy that the guard holds: not at rest yet
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

// The guard's energy and gradient: stiffness / 2 (|d| - distance)^2 for each node whose move d across
// the reference tangent is longer than the distance.
class Guard {
 public:
  Guard(const RodState& reference, double distance, double stiffness)
      : reference_(&reference), distance_(distance), stiffness_(stiffness) {}

  double add_gradient(const RodState& state, Gradient& gradient) const {
    if (distance_ <= 0) return 0;
    double energy = 0;
    const Index edges = state.edge_count();
    for (Index i = 0; i < state.node_count(); ++i) {
      const Vec3 t =
          third_axis(reference_->frames[static_cast<std::size_t>(std::min(i, edges - 1))]);
      const Vec3 move = state.nodes.col(i) - reference_->nodes.col(i);
      const Vec3 across = move - move.dot(t) * t;
      const double excess = across.norm() - distance_;
      if (excess <= 0) continue;
      energy += stiffness_ / 2 * excess * excess;
      gradient.node.col(i) += stiffness_ * excess / (excess + distance_) * across;
    }
    return energy;
  }

 private:
  const RodState* reference_;
  double distance_, stiffness_;
};

// One round: one chart, one factor.
DescentReport descend_once(Best& best, const HeldUnknowns& held, const EnergyFunctions& energy,
                           const EquilibriumOptions& options, double guard_distance,
                           int max_evaluations) {
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
  const Guard guard(chart.reference(), guard_distance, options.guard.stiffness);
  // NLopt stops by itself where no component of the gradient by y exceeds 1e-8, and loses its way
  // where values are huge. The first gradient of a round is made 1e3 by the unit of y (and of the
  // energy, its square), so that a round can gain eleven decades.
  double unit = 0;
  const Objective objective = [&](const Eigen::VectorXd& y, Eigen::VectorXd& by_y) {
    preconditioner.to_step(y, step);
    step = x0 + unit * step;
    chart.set_state(step, state);
    set_zero(gradient, state);
    energy.prepare(state);
    const double guarded = guard.add_gradient(state, gradient);
    const double value = energy.add_gradient(state, gradient) + guarded;
    chart.pull_back(state, gradient.node, gradient.frame, by_x);
    const double residual = by_x.cwiseProduct(inverse_tolerance).cwiseAbs().maxCoeff();
    if (best.improved_by(value, residual)) {
      best.state = state;
      best.energy = value;
      best.residual = residual;
      best.guarded = guarded;
      best.inlet_length_force = gradient.inlet_length;
    }
    const bool at_rest = residual <= 1 && best.energy == value;
    preconditioner.to_gradient(by_x, by_y);
    if (unit == 0) unit = std::max(by_y.cwiseAbs().maxCoeff() / 1e3, 1e-150);
    by_y /= unit;
    return Evaluation{value / (unit * unit), at_rest};
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
  double guard_distance = options.guard.distance;
  while (true) {
    best.energy -= best.guarded;
    best.guarded = 0;
    const Best before = best;
    const int left = options.method.max_evaluations - report.evaluations;
    const DescentReport round = descend_once(best, held, energy, options, guard_distance,
                                             std::min(options.method.refactor_every, left));
    report.evaluations += round.evaluations;
    ++report.factorizations;
    if (best.energy == HUGE_VAL) throw NumericalFailure("the start has no finite energy");
    if (options.guard.admissible && !options.guard.admissible(before.state, best.state)) {
      best = before;
      ++report.rounds_taken_back;
      guard_distance /= 2;
      if (guard_distance >= options.guard.distance / 16) continue;
      report.end = EquilibriumEnd::inadmissible;
      break;
    }
    guard_distance = options.guard.distance;
    if (best.residual <= 1 && best.guarded == 0) {
      report.end = EquilibriumEnd::converged;
      break;
    }
    if (report.evaluations >= options.method.max_evaluations) {
      report.end = EquilibriumEnd::evaluation_limit;
      break;
    }
    const bool progress = best.energy < before.energy - 1e-12 * std::abs(best.energy) ||
                          best.residual < 0.9 * before.residual;
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
