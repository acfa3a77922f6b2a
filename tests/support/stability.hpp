#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <functional>

#include "elastic_rest.hpp"

namespace wirepack::testing {

/// Adds dE/d(state) of a conservative system, or minus the generalized forces of any other.
using ForceField = std::function<void(const RodState&, Gradient&)>;

inline ForceField elastic_forces(const RodParams& params) {
  return [params](const RodState& state, Gradient& gradient) {
    StretchEnergy(params).add_gradient(state, gradient);
    JointEnergy(params).add_gradient(state, gradient);
  };
}

/// Derivative of the forces by the unknowns: central differences with one Richardson step, so the
/// truncation (step / edge length)^4 is below round-off.
inline Eigen::MatrixXd jacobian(const RodState& state, const HeldUnknowns& held,
                                const ForceField& forces, double step) {
  const FrameChart chart(state, held);
  const Eigen::VectorXd x0 = chart.unknowns();
  RodState moved = chart.reference();
  Gradient gradient;
  const auto forces_at = [&](Index k, double offset) {
    Eigen::VectorXd x = x0, by_x;
    x[k] += offset;
    chart.set_state(x, moved);
    set_zero(gradient, moved);
    forces(moved, gradient);
    chart.pull_back(moved, gradient.node, gradient.frame, by_x);
    return by_x;
  };
  Eigen::MatrixXd result(chart.size(), chart.size());
  for (Index k = 0; k < chart.size(); ++k) {
    const Eigen::VectorXd wide = (forces_at(k, 2 * step) - forces_at(k, -2 * step)) / (4 * step);
    const Eigen::VectorXd narrow = (forces_at(k, step) - forces_at(k, -step)) / (2 * step);
    result.col(k) = narrow + (narrow - wide) / 3;
  }
  return result;
}

/// Second derivative of the elastic energy.
inline Eigen::MatrixXd elastic_hessian(const RodState& state, const HeldUnknowns& held,
                                       const RodParams& params) {
  const Eigen::MatrixXd h =
      jacobian(state, held, elastic_forces(params), 1e-4 * params.edge_length);
  return (h + h.transpose()) / 2;
}

/// Smallest positive load at which `unloaded - load * per_load` is singular, from the largest real
/// eigenvalue of unloaded^-1 per_load. `unloaded` is symmetric positive definite.
inline double critical_multiplier(const Eigen::MatrixXd& unloaded,
                                  const Eigen::MatrixXd& per_load) {
  const Eigen::LLT<Eigen::MatrixXd> factor(unloaded);
  EXPECT_EQ(factor.info(), Eigen::Success) << "the unloaded rod is not stable";
  // L^-1 G L^-T has the same eigenvalues and is symmetric when G is
  const Eigen::MatrixXd half = factor.matrixL().solve(per_load);
  const Eigen::MatrixXd reduced = factor.matrixL().solve(half.transpose()).transpose();
  const double asymmetry = (reduced - reduced.transpose()).cwiseAbs().maxCoeff();
  if (asymmetry < 1e-6 * reduced.cwiseAbs().maxCoeff()) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((reduced + reduced.transpose()) / 2,
                                                                Eigen::EigenvaluesOnly);
    return 1 / solver.eigenvalues().maxCoeff();
  }
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(reduced, false);
  double largest = 0;
  for (const std::complex<double>& value : solver.eigenvalues()) {
    if (std::abs(value.imag()) < 1e-6 * std::abs(value)) largest = std::max(largest, value.real());
  }
  return 1 / largest;
}

/// Zero of a nearly linear function by the secant rule.
template <class F>
double root_near(F&& f, double first, double second) {
  double f_first = f(first);
  for (int k = 0; k < 20; ++k) {
    const double f_second = f(second);
    if (f_second == f_first) break;
    const double third = second - f_second * (second - first) / (f_second - f_first);
    first = second;
    f_first = f_second;
    second = third;
    if (std::abs(second - first) < 1e-13 * std::abs(second)) break;
  }
  return second;
}

enum class End { free, pinned, clamped };

/// A straight rod along z, uniformly compressed by the axial load, whose last end may move along
/// z; nodes move along x alone, so the lowest stiffness is that of Euler buckling.
struct Column {
  RodParams params;
  RodState state;
  HeldUnknowns held;
};

inline Column compressed_column(Index edges, End first, End last, double load, double stretch) {
  Column column{unit_rod(edges, 1, stretch), {}, {}};
  Points nodes = Points::Zero(3, edges + 1);
  for (Index i = 0; i <= edges; ++i) {
    nodes(2, i) = static_cast<double>(i) / static_cast<double>(edges) * (1 - load / stretch);
  }
  column.state =
      make_rod(nodes, column.params,
               {.first_clamped = first == End::clamped, .last_clamped = last == End::clamped});
  column.held = HeldUnknowns::none(column.state);
  column.held.angle.assign(column.held.angle.size(), true);
  hold_coordinate(column.held, 1);
  hold_coordinate(column.held, 2);
  if (first != End::free) column.held.hold_node(0);
  if (last != End::free) column.held.hold_node(edges);
  return column;
}

/// Lowest stiffness v^T H v, |v| = 1. The mode v comes from the Hessian; its stiffness then from
/// the energies at +-A v, extrapolated to A = 0, because an eigenvalue of a matrix with entries of
/// N^3 carries a rounding error of 1e-16 N^3 / (pi^4 / N) while energies are sums of squares.
inline double lowest_stiffness(const Column& column) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      elastic_hessian(column.state, column.held, column.params));
  const Eigen::VectorXd mode = solver.eigenvectors().col(0);
  const double largest = mode.cwiseAbs().maxCoeff();
  const FrameChart chart(column.state, column.held);
  RodState moved = chart.reference();
  const auto energy_at = [&](double amplitude) {
    chart.set_state(chart.unknowns() + amplitude * mode, moved);
    return elastic_energy(moved, column.params);
  };
  const double straight = energy_at(0);
  std::array<double, 4> table{};
  double amplitude = 0.03 / largest;  // 3 % of the length
  for (double& entry : table) {
    entry = (energy_at(amplitude) - 2 * straight + energy_at(-amplitude)) / (amplitude * amplitude);
    amplitude /= 2;
  }
  double power = 4;  // even powers of the amplitude
  for (std::size_t level = 1; level < table.size(); ++level, power *= 4) {
    for (std::size_t k = 0; k + level < table.size(); ++k) {
      table[k] = table[k + 1] + (table[k + 1] - table[k]) / (power - 1);
    }
  }
  return table[0];
}

/// Buckling load of the column in YI / L^2, found from the compressed, extensible rod.
inline double euler_load(Index edges, End first, End last, double guess, double stretch) {
  return root_near(
      [&](double load) {
        return lowest_stiffness(compressed_column(edges, first, last, load, stretch));
      },
      0.95 * guess, guess);
}

}  // namespace wirepack::testing
