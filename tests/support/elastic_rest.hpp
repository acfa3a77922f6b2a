#pragma once

#include <gtest/gtest.h>
#include <utility>

#include "wirepack/core/rotation.hpp"
#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/load_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/solve/equilibrium.hpp"

namespace wirepack::testing {

/// Stretching stiffness YA L^2 / YI at which a rod of length L is inextensible for textbook
/// purposes: under a load of 10 YI / L^2 it strains by 2.5e-7. More would drown small forces in
/// the round-off of the axial springs, about 1e-16 N YA.
constexpr double inextensible = 4e7;

/// A rod with YI = 1 of the given length, in `edges` edges; stretch = YA L^2 / YI.
inline RodParams unit_rod(Index edges, double length = 1, double stretch = inextensible,
                          double poisson_ratio = 1.0 / 3) {
  RodParams params;
  params.radius = 0.01 * length;
  params.youngs_modulus = 4 / (pi * std::pow(params.radius, 4));
  params.poisson_ratio = poisson_ratio;
  params.stretch_multiplier = stretch / 4e4;  // YA L^2 / YI = 4 L^2 / a^2 = 4e4
  params.edge_length = length / static_cast<double>(edges);
  return params;
}

/// Largest force [YI / L^2 with L = 1] and moment [YI / L] left at rest. With the inextensible rod
/// of 200 edges the round-off of the axial springs is 1e-6.
struct RestTolerance {
  double force = 5e-6;
  double moment = 1e-6;
};

/// Newton steps from a rest that a minimizer has found. A minimizer judges steps by energies, which
/// are rounded to 1e-16 E, so it leaves forces of sqrt(1e-16 E k), k the stiffest spring: too much
/// for the reactions of a nearly inextensible rod. Derivatives of the exact gradient by
/// differences; the matrix must be positive definite, so a saddle is not taken for a rest.
inline void polish(RodState& state, const HeldUnknowns& held, const EnergyTerms& energy,
                   double edge_length, RestTolerance tolerance) {
  double worst = HUGE_VAL;
  for (int step = 0; step < 6; ++step) {
    const FrameChart chart(state, held);
    RodState moved = chart.reference();
    Gradient gradient;
    const auto by_unknowns = [&](const Eigen::VectorXd& x) {
      Eigen::VectorXd by_x;
      chart.set_state(x, moved);
      set_zero(gradient, moved);
      energy.add_gradient(moved, gradient);
      chart.pull_back(moved, gradient.node, gradient.frame, by_x);
      return by_x;
    };
    const Eigen::VectorXd x0 = chart.unknowns();
    const Eigen::VectorXd residual = by_unknowns(x0);
    worst = 0;
    for (Index block = 0; block < chart.block_count(); ++block) {
      for (int slot = 0; slot < 4; ++slot) {
        if (const Index u = chart.unknown(block, slot); u >= 0) {
          worst = std::max(worst,
                           std::abs(residual[u]) / (slot < 3 ? tolerance.force : tolerance.moment));
        }
      }
    }
    if (worst <= 1) return;
    Eigen::MatrixXd hessian(chart.size(), chart.size());
    const double h = 1e-5 * edge_length;
    for (Index k = 0; k < chart.size(); ++k) {
      const Eigen::VectorXd offset = h * Eigen::VectorXd::Unit(chart.size(), k);
      hessian.col(k) = (by_unknowns(x0 + offset) - by_unknowns(x0 - offset)) / (2 * h);
    }
    const Eigen::LLT<Eigen::MatrixXd> factor((hessian + hessian.transpose()) / 2);
    ASSERT_EQ(factor.info(), Eigen::Success) << "the rest found is not stable";
    chart.set_state(x0 - factor.solve(residual), moved);
    state = moved;
  }
  FAIL() << "forces at rest are " << worst << " times their tolerance";
}

/// Moves the rod to rest under dead loads by the solver of the library alone; it must converge.
inline EquilibriumReport solver_rest(RodState& state, const HeldUnknowns& held,
                                     const RodParams& params, const Loads& loads,
                                     RestTolerance tolerance) {
  StretchEnergy stretch(params);
  JointEnergy joints(params);
  LoadEnergy load(params, loads);
  EnergyTerms total{stretch, joints, load};
  const EquilibriumReport report = solve_equilibrium(
      state, held, total, {tolerance.force, tolerance.moment, 1e-6 * stiffness(params).bend, {}});
  EXPECT_LE(report.residual, 1) << "after " << report.work.evaluations << " evaluations, stalled: "
                                << (report.end == EquilibriumEnd::stalled);
  return report;
}

/// The same to what the rounding of the energy allows for a nearly inextensible rod, then Newton
/// steps to the tolerance.
inline EquilibriumReport rest(RodState& state, const HeldUnknowns& held, const RodParams& params,
                              const Loads& loads = {}, RestTolerance tolerance = {}) {
  const EquilibriumReport report =
      solver_rest(state, held, params, loads, {200 * tolerance.force, 200 * tolerance.moment});
  StretchEnergy stretch(params);
  JointEnergy joints(params);
  LoadEnergy load(params, loads);
  EnergyTerms total{stretch, joints, load};
  polish(state, held, total, params.edge_length, tolerance);
  return report;
}

/// What holds the rod: force on each node and moment on each clamp frame (its full vector). The
/// moments on edge frames have been turned into the couples of node forces they act by.
struct Reactions {
  Points force;   ///< 3 x N
  Points moment;  ///< 3 x frames; edge frames: about the tangent
};

inline Reactions reactions(const RodState& state, const RodParams& params) {
  Gradient gradient;
  set_zero(gradient, state);
  StretchEnergy(params).add_gradient(state, gradient);
  JointEnergy(params).add_gradient(state, gradient);
  const FrameChart chart(state, HeldUnknowns::none(state));
  Eigen::VectorXd by_x;
  chart.pull_back(state, gradient.node, gradient.frame, by_x);
  Reactions result{gradient.node, gradient.frame};
  for (Index i = 0; i < state.node_count(); ++i) {
    result.force.col(i) = by_x.segment<3>(chart.unknown(i, 0));
  }
  for (Index j = 0; j < state.edge_count(); ++j) {
    const Vec3 t = third_axis(state.frames[static_cast<std::size_t>(j)]);
    result.moment.col(j) = t * by_x[chart.unknown(j, 3)];
  }
  return result;
}

inline double elastic_energy(const RodState& state, const RodParams& params) {
  Gradient unused;
  set_zero(unused, state);
  return StretchEnergy(params).add_gradient(state, unused) +
         JointEnergy(params).add_gradient(state, unused);
}

/// Holds one coordinate (0, 1, 2) of every node, e.g. to keep a problem in a plane.
inline void hold_coordinate(HeldUnknowns& held, int coordinate) {
  for (std::size_t k = static_cast<std::size_t>(coordinate); k < held.coordinate.size(); k += 3) {
    held.coordinate[k] = true;
  }
}

inline void hold_angle(HeldUnknowns& held, Index frame) {
  held.angle[static_cast<std::size_t>(frame)] = true;
}

/// Turns frame j of an open rod by total * (arc of its middle) / length, clamps by 0 and total.
inline void twist_uniformly(RodState& state, double total) {
  const auto edges = static_cast<double>(state.edge_count());
  const auto turn = [&](Index frame, double angle) {
    Quat& q = state.frames[static_cast<std::size_t>(frame)];
    q = rotation_about(third_axis(q), angle) * q;
  };
  for (Index j = 0; j < state.edge_count(); ++j) {
    turn(j, total * (static_cast<double>(j) + 0.5) / edges);
  }
  for (double& guide : state.twist_guide) guide += total / edges;
  if (state.ends.first_clamped) state.twist_guide.front() -= total / (2 * edges);
  if (state.ends.last_clamped) {
    turn(state.last_clamp_frame(), total);
    state.twist_guide.back() -= total / (2 * edges);
  }
}

/// Unit vector along edge j.
inline Vec3 tangent(const RodState& state, Index edge) {
  return (state.nodes.col(next_node(state, edge)) - state.nodes.col(edge)).normalized();
}

}  // namespace wirepack::testing
