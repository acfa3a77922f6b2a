#include "wirepack/solve/equilibrium.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "wirepack/core/error.hpp"
#include "wirepack/rod/turning_chart.hpp"
#include "wirepack/solve/minimizer.hpp"
#include "wirepack/solve/preconditioner.hpp"

namespace wirepack {

namespace {

// A round that has gone so much of the guard's distance and tries to go beyond it ends: further steps
// would only bounce off the guard.
constexpr double nearly_all = 0.9;

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

// Adds the time since its last lap to where it went.
class Stopwatch {
 public:
  void lap(double& seconds) {
    const Clock::time_point now = Clock::now();
    seconds += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
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

struct GuardReport {
  double energy = 0;
  double longest = 0;  // move across the wire
};

// The guard's energy: stiffness / 2 (|d| - distance)^2 for each node whose move d across the
// reference tangent is longer than the distance. Sets its derivative by the moves.
GuardReport guard_energy(const FrameChart& chart, const Points& moves, double distance,
                         double stiffness, Points& by_move) {
  by_move.setZero(3, moves.cols());
  GuardReport report;
  if (distance <= 0) return report;
  const Index last_edge = chart.reference().edge_count() - 1;
  for (Index i = 0; i < moves.cols(); ++i) {
    const Vec3 t = chart.reference_tangent(std::min(i, last_edge));
    const Vec3 across = moves.col(i) - moves.col(i).dot(t) * t;
    const double length = across.norm(), excess = length - distance;
    report.longest = std::max(report.longest, length);
    if (excess <= 0) continue;
    report.energy += stiffness / 2 * excess * excess;
    by_move.col(i) = stiffness * excess / length * across;
  }
  return report;
}

Preconditioner preconditioner_at(const FrameChart& chart, const EnergyFunctions& energy,
                                 const EquilibriumOptions& options, SolverWork& work) {
  const auto curvature = [&](double exactness) {
    CurvatureModel model(chart, exactness);
    energy.add_curvature(chart.reference(), model);
    return model.lower_triangle(options.shift);
  };
  const auto factored = [&](double exactness) {
    ++work.factorizations;
    const auto definiteness = exactness > 0 ? Preconditioner::Definiteness::unknown
                                            : Preconditioner::Definiteness::positive;
    return Preconditioner::factored(curvature(exactness), options.shift, definiteness);
  };
  std::optional<Preconditioner> result = factored(options.exactness);
  if (!result && options.exactness > 0) result = factored(0);
  if (!result) throw NumericalFailure("the curvature model is not positive definite");
  return std::move(*result);
}

// One round: one chart, one factor.
void descend_once(Best& best, const HeldUnknowns& held, const EnergyFunctions& energy,
                  const EquilibriumOptions& options, double guard_distance, int max_evaluations,
                  SolverWork& work) {
  Stopwatch watch;
  const FrameChart chart(best.state, held);
  work.list_builds += energy.prepare(chart.reference());
  watch.lap(work.list_seconds);
  Preconditioner preconditioner = preconditioner_at(chart, energy, options, work);
  watch.lap(work.factorization_seconds);

  TurningChart turning(chart, options.turning_taper);
  const Eigen::VectorXd inverse_tolerance = inverse_tolerances(chart, options);
  RodState state = chart.reference();
  Gradient gradient;
  Points by_move;
  Eigen::VectorXd step, by_x, by_step;
  // NLopt stops by itself where no component of the gradient by y exceeds 1e-8, and loses its way
  // where values are huge. The first gradient of a round is made 1e3 by the unit of y (and of the
  // energy, its square), so that a round can gain eleven decades.
  double unit = 0;
  double way = 0;  // longest move across the wire at the lowest point of this round
  const Objective objective = [&](const Eigen::VectorXd& y, Eigen::VectorXd& by_y) {
    watch.lap(work.descent_seconds);
    preconditioner.to_step(y, step);
    step *= unit;
    watch.lap(work.solve_seconds);
    turning.set_state(step, state);
    watch.lap(work.chart_seconds);
    work.list_builds += energy.prepare(state);
    watch.lap(work.list_seconds);
    set_zero(gradient, state);
    const GuardReport guard =
        guard_energy(chart, turning.moves(), guard_distance, options.guard.stiffness, by_move);
    const double value = energy.add_gradient(state, gradient) + guard.energy;
    watch.lap(work.energy_seconds);
    turning.pull_back(state, gradient.node, gradient.frame, by_move, by_x, by_step);
    const double residual = by_x.cwiseProduct(inverse_tolerance).cwiseAbs().maxCoeff();
    if (best.improved_by(value, residual)) {
      best.state = state;
      best.energy = value;
      best.residual = residual;
      best.guarded = guard.energy;
      best.inlet_length_force = gradient.inlet_length;
      way = guard.longest;
    }
    const bool at_rest = residual <= 1 && best.energy == value;
    const bool at_guard = guard.energy > 0 && way >= nearly_all * guard_distance;
    watch.lap(work.chart_seconds);
    preconditioner.to_gradient(by_step, by_y);
    watch.lap(work.solve_seconds);
    if (unit == 0) unit = std::max(by_y.cwiseAbs().maxCoeff() / 1e3, 1e-150);
    by_y /= unit;
    return Evaluation{value / (unit * unit), at_rest || at_guard};
  };
  const DescentReport report = descend(objective, Eigen::VectorXd::Zero(chart.size()),
                                       {max_evaluations, options.method.memory});
  watch.lap(work.descent_seconds);
  work.evaluations += report.evaluations;
  if (!held.frames_follow) carry_frames(best.state);
}

}  // namespace

EquilibriumReport solve_equilibrium(RodState& state, const HeldUnknowns& held,
                                    const EnergyFunctions& energy,
                                    const EquilibriumOptions& options) {
  Best best;
  best.state = state;
  EquilibriumReport report;
  SolverWork& work = report.work;
  const auto admissible = [&](const RodState& before) {
    if (!options.guard.admissible) return true;
    Stopwatch watch;
    const bool answer = options.guard.admissible(before, best.state);
    watch.lap(work.passage_seconds);
    return answer;
  };
  int fruitless_rounds = 0;
  double guard_distance = options.guard.distance;
  while (true) {
    best.energy -= best.guarded;
    best.guarded = 0;
    const Best before = best;
    const auto left = static_cast<int>(options.method.max_evaluations - work.evaluations);
    descend_once(best, held, energy, options, guard_distance,
                 std::min(options.method.refactor_every, left), work);
    if (best.energy == HUGE_VAL) throw NumericalFailure("the start has no finite energy");
    if (!admissible(before.state)) {
      best = before;
      ++work.rounds_taken_back;
      guard_distance /= 2;
      const bool too_short = guard_distance < options.guard.distance / 16;
      const bool spent = work.evaluations >= options.method.max_evaluations;
      if (!too_short && !spent) continue;
      report.end = too_short ? EquilibriumEnd::inadmissible : EquilibriumEnd::evaluation_limit;
      break;
    }
    guard_distance = options.guard.distance;
    if (best.residual <= 1 && best.guarded == 0) {
      report.end = EquilibriumEnd::converged;
      break;
    }
    if (work.evaluations >= options.method.max_evaluations) {
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
