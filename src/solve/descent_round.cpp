#include "descent_round.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "wirepack/core/error.hpp"
#include "wirepack/rod/turning_chart.hpp"
#include "wirepack/solve/minimizer.hpp"
#include "wirepack/solve/preconditioner.hpp"

#include "shifted_hessian.hpp"
#include "stopwatch.hpp"

namespace wirepack {

namespace {

// A round ends when it has gone so much of the guard's distance and tries to go beyond it: further
// steps would only bounce off the guard.
constexpr double nearly_all = 0.9;

// Differences of energies below this share of the energy are rounded too much to guide a line
// search. Those of the last steps are so small.
constexpr double resolved_share = 1e-13;

// Inverse tolerance of each unknown: the residual is the largest gradient component times its own.
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
  double longest = 0;  // longest move across the wire
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

Preconditioner preconditioner_at(const FrameChart& chart, const EnergyTerms& energy,
                                 const EquilibriumOptions& options, SolverWork& work) {
  const auto factored = [&](double exactness) {
    return factored_hessian(chart, shifted_hessian(chart, energy, options, exactness), options,
                            exactness == 0, {}, work);
  };
  std::optional<Preconditioner> result = factored(options.exactness);
  if (!result && options.exactness > 0) result = factored(0);
  if (!result) throw NumericalFailure("the curvature model is not positive definite");
  return std::move(*result);
}

/// Point of a round whose height is known.
struct KnownPoint {
  double height = 0;
  Energy energy;
  double guard = 0;
  Eigen::VectorXd step, by_step;
};

// Heights of points above the start of a round. Between points far apart, the height changes by the
// difference of their energies. Close to a minimum that is f^2 / (2 k), f the remaining force on a
// spring of stiffness k, and drowns in the round-off of the whole energy. Between points that close
// the height changes by the work of the gradient instead, by the trapezoidal rule. This is exact
// but for third derivatives, and its round-off is that of the forces.
class Heights {
 public:
  double above_start(const Energy& energy, double guard, const Eigen::VectorXd& step,
                     const Eigen::VectorXd& by_step) const {
    if (!lowest_) return 0;
    const double apart = difference(energy, lowest_->energy) + (guard - lowest_->guard);
    const double scale = std::abs(double(energy)) + guard;
    if (!(std::abs(apart) < resolved_share * scale)) return lowest_->height + apart;
    return lowest_->height + (lowest_->by_step + by_step).dot(step - lowest_->step) / 2;
  }
  void set_lowest(double height, const Energy& energy, double guard, const Eigen::VectorXd& step,
                  const Eigen::VectorXd& by_step) {
    if (!lowest_) lowest_.emplace();
    lowest_->height = height;
    lowest_->energy = energy;
    lowest_->guard = guard;
    lowest_->step = step;
    lowest_->by_step = by_step;
  }
  bool known() const { return lowest_.has_value(); }
  double lowest() const { return lowest_ ? lowest_->height : 0; }

 private:
  std::optional<KnownPoint> lowest_;
};

}  // namespace

RoundReport descend_one_round(LowestPoint& lowest, const HeldUnknowns& held,
                              const EnergyTerms& energy, const EquilibriumOptions& options,
                              double guard_distance, int max_evaluations, SolverWork& work) {
  Stopwatch watch;
  const FrameChart chart(lowest.state, held);
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
  Heights heights;
  // NLopt stops by itself where no component of the gradient by y exceeds 1e-8, and fails where
  // values are huge. The unit of y (its square is that of the energy) makes the largest component
  // of a round's first gradient 1e3, so that a round can gain eleven decades.
  double unit = 0;
  double way = 0;  // longest move across the wire at the lowest point
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
    const Energy value = energy.add_gradient(state, gradient);
    watch.lap(work.energy_seconds);
    turning.pull_back(state, gradient.node, gradient.frame, by_move, by_x, by_step);
    const double residual = by_x.cwiseProduct(inverse_tolerance).cwiseAbs().maxCoeff();
    const double height = heights.above_start(value, guard.energy, step, by_step);
    if (!heights.known() || height < heights.lowest() ||
        (height == heights.lowest() && residual < lowest.residual)) {
      if (std::isfinite(height) && std::isfinite(double(value))) {
        heights.set_lowest(height, value, guard.energy, step, by_step);
        lowest = {state, value, guard.energy, residual, gradient.inlet_length};
        way = guard.longest;
      }
    }
    const bool in_equilibrium = residual <= 1 && height == heights.lowest();
    const bool at_guard = guard.energy > 0 && way >= nearly_all * guard_distance;
    watch.lap(work.chart_seconds);
    preconditioner.to_gradient(by_step, by_y);
    watch.lap(work.solve_seconds);
    if (unit == 0) unit = std::max(by_y.cwiseAbs().maxCoeff() / 1e3, 1e-150);
    by_y /= unit;
    return Evaluation{height / (unit * unit), in_equilibrium || at_guard};
  };
  const DescentReport report =
      descend(objective, Eigen::VectorXd::Zero(chart.size()),
              {max_evaluations, options.method.memory, options.method.method});
  watch.lap(work.descent_seconds);
  work.evaluations += report.evaluations;
  if (!heights.known()) throw NumericalFailure("the start has no finite energy");
  if (!held.frames_follow) carry_frames(lowest.state);
  return {-heights.lowest(), guard_distance > 0 && way >= nearly_all * guard_distance,
          preconditioner.order()};
}

}  // namespace wirepack
