#include "wirepack/solve/stability.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <optional>

#include "wirepack/core/error.hpp"
#include "wirepack/core/random.hpp"
#include "wirepack/solve/preconditioner.hpp"

#include "shifted_hessian.hpp"
#include "stopwatch.hpp"

namespace wirepack {

namespace {

// An eigenvalue below this is one of a saddle: a load that is a hundredth of a per cent too high.
// Rigid motions that cost nothing have eigenvalues of zero, but for rounding.
constexpr double unstable_below = -1e-4;
// Exactness of the model that is positive definite if and only if no eigenvalue is below that: it
// is (H + 1e-4 P) / (1 + 1e-4).
constexpr double exactness_of_test = 1 / (1 - unstable_below);
// The shift of preconditioners is larger than the curvature of slow bending modes. The test uses
// this share of it.
constexpr double shift_share = 1e-4;
constexpr int lanczos_steps = 40;

using Sparse = Eigen::SparseMatrix<double>;

EquilibriumOptions with_small_shift(EquilibriumOptions options) {
  options.shift *= shift_share;
  return options;
}

// Lowest eigenpair of L^-1 H L^-T, P = L L^T, by Lanczos's method with full orthogonalization; the
// vector is turned back into x = L^-T y.
CurvatureMode lowest_eigenpair(const Sparse& hessian, Preconditioner& preconditioner) {
  const Index n = hessian.rows();
  const auto count = std::min<Index>(lanczos_steps, n);
  Random random(1);
  Eigen::MatrixXd basis(n, count);
  Eigen::VectorXd y(n), x, product, by_y;
  for (double& v : y) v = random.symmetric();
  Eigen::MatrixXd projected = Eigen::MatrixXd::Zero(count, count);
  Index used = 0;
  for (; used < count; ++used) {
    const double length = y.norm();
    if (length < 1e-12) break;
    basis.col(used) = y / length;
    if (used > 0) projected(used, used - 1) = projected(used - 1, used) = length;
    preconditioner.to_step(basis.col(used), x);
    product = hessian.selfadjointView<Eigen::Lower>() * x;
    preconditioner.to_gradient(product, by_y);
    projected(used, used) = basis.col(used).dot(by_y);
    const auto known = basis.leftCols(used + 1);
    y = by_y - known * (known.transpose() * by_y);
    y -= known * (known.transpose() * y);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(projected.topLeftCorner(used, used));
  const Eigen::VectorXd lowest = basis.leftCols(used) * solver.eigenvectors().col(0);
  preconditioner.to_step(lowest, x);
  return {solver.eigenvalues()[0], x};
}

// Of a Hessian with a small shift. Beside very stiff contacts that shift drowns in the rounding of
// the Gauss-Newton part's pivots; `options` have a larger one.
CurvatureMode softest_mode(const FrameChart& chart, const Sparse& hessian,
                           const EnergyTerms& energy, const EquilibriumOptions& options,
                           SolverWork& work) {
  const auto gauss_newton_factor = [&](const EquilibriumOptions& shifted) {
    return factored_hessian(chart, shifted_hessian(chart, energy, shifted, 0), shifted, true, {},
                            work);
  };
  auto factor = gauss_newton_factor(with_small_shift(options));
  if (!factor) factor = gauss_newton_factor(options);
  if (!factor) throw NumericalFailure("the curvature model is not positive definite");
  return lowest_eigenpair(hessian, *factor);
}

// Curvature of the energy along a direction v of the chart, v . H v, by central differences of the
// gradient: the model of the Hessian leaves out what a term does not know.
double curvature_along(const Eigen::VectorXd& direction, const FrameChart& chart,
                       const HeldUnknowns& held, const EnergyTerms& energy) {
  const RodState& reference = chart.reference();
  const double edge = (reference.nodes.col(1) - reference.nodes.col(0)).norm();
  const double spacing = 1e-5 * edge / direction.cwiseAbs().maxCoeff();
  RodState moved = reference;
  Gradient gradient;
  Eigen::VectorXd by_x;
  const auto slope_at = [&](double way) {
    chart.set_state(chart.unknowns() + way * direction, moved);
    if (!held.frames_follow) carry_frames(moved);
    set_zero(gradient, moved);
    energy.add_gradient(moved, gradient);
    chart.pull_back(moved, gradient.node, gradient.frame, by_x);
    return by_x.dot(direction);
  };
  return (slope_at(spacing) - slope_at(-spacing)) / (2 * spacing);
}

// Moves the state down along the direction, on either side, far enough that it is no equilibrium
// any more. Returns false where no such way leads down.
bool move_down(RodState& state, const HeldUnknowns& held, const EnergyTerms& energy,
               const Eigen::VectorXd& direction, double length) {
  const FrameChart chart(state, held);
  RodState moved = chart.reference();
  Gradient gradient;
  const auto energy_at = [&](double way) {
    const Eigen::VectorXd x = chart.unknowns() + way * direction;
    chart.set_state(x, moved);
    if (!held.frames_follow) carry_frames(moved);
    energy.prepare(moved);
    set_zero(gradient, moved);
    return energy.add_gradient(moved, gradient);
  };
  const double longest = direction.cwiseAbs().maxCoeff();
  const Energy start = energy_at(0);
  double best = 0, best_way = 0;
  for (double way = 1e-3 * length / longest; way * longest <= length; way *= 2) {
    for (const double signed_way : {way, -way}) {
      const double change = difference(energy_at(signed_way), start);
      if (change >= best) continue;
      best = change;
      best_way = signed_way;
    }
  }
  if (best_way == 0) return false;
  energy_at(best_way);
  state = moved;
  return true;
}

}  // namespace

Sparse hessian(const FrameChart& chart, const EnergyTerms& energy) {
  CurvatureModel model(chart, 1);
  energy.add_curvature(chart.reference(), model);
  return model.lower_triangle(0, 0);
}

CurvatureMode softest_mode(const RodState& state, const HeldUnknowns& held,
                           const EnergyTerms& energy, const EquilibriumOptions& options,
                           SolverWork& work) {
  const FrameChart chart(state, held);
  work.list_builds += energy.prepare(chart.reference());
  return softest_mode(chart, shifted_hessian(chart, energy, with_small_shift(options), 1), energy,
                      options, work);
}

Stability stability_of(const RodState& state, const HeldUnknowns& held, const EnergyTerms& energy,
                       const EquilibriumOptions& options, SolverWork& work,
                       const std::vector<int>& order) {
  Stopwatch watch;
  const EquilibriumOptions small_shift = with_small_shift(options);
  const FrameChart chart(state, held);
  work.list_builds += energy.prepare(chart.reference());
  Stability result;
  if (!is_positive_definite(chart, shifted_hessian(chart, energy, small_shift, exactness_of_test),
                            small_shift, order, work)) {
    const Sparse exact = shifted_hessian(chart, energy, small_shift, 1);
    const CurvatureMode softest = softest_mode(chart, exact, energy, options, work);
    result.lowest_eigenvalue = softest.eigenvalue;
    result.stable = softest.eigenvalue > unstable_below ||
                    curvature_along(softest.direction, chart, held, energy) > unstable_below;
    if (!result.stable) result.direction = softest.direction;
  }
  watch.lap(work.stability_seconds);
  return result;
}

bool escape_saddle(RodState& state, const HeldUnknowns& held, const EnergyTerms& energy,
                   const EquilibriumOptions& options, double length, EquilibriumReport& report) {
  const Stability stability = stability_of(state, held, energy, options, report.work, report.order);
  report.stable = stability.stable;
  return !stability.stable && move_down(state, held, energy, stability.direction, length);
}

EquilibriumReport solve_stable_equilibrium(RodState& state, const HeldUnknowns& held,
                                           const EnergyTerms& energy,
                                           const EquilibriumOptions& options, double length) {
  SolverWork work;
  for (int saddles = 0;; ++saddles) {
    EquilibriumReport report = solve_equilibrium(state, held, energy, options);
    report.work += work;
    if (report.end != EquilibriumEnd::converged) return report;
    if (saddles == most_saddles) {
      report.stable = false;  // as far as is known
      return report;
    }
    if (!escape_saddle(state, held, energy, options, length, report)) return report;
    work = report.work;
  }
}

}  // namespace wirepack
