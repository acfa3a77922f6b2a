#include "wirepack/solve/stability.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/load_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"

#include "../../support/clamped_rod.hpp"

namespace wirepack {
namespace {

// A straight cantilever under a thrust at its tip, in parts of the load at which it buckles:
// pi^2 / 4 YI / L^2 (Euler), of the wire that is shorter and less stiff under that load by its
// strain.
struct Strut {
  explicit Strut(double part, double unit = 1) {
    params.radius = params.edge_length = unit;
    params.stretch_multiplier = 100;
    const double length = 40 * unit;
    thrust = part * pi * pi / 4 * stiffness(params).bend / (length * length);
    auto clamped = testing::clamped_rod(40, params, {.last_clamped = true});
    rod = std::move(clamped.rod);
    held = std::move(clamped.held);
    const Vec3 along = (rod.nodes.col(40) - rod.nodes.col(0)).normalized();
    loads.forces.push_back({0, thrust * along});
    options = equilibrium_options(stiffness(params).bend, unit,
                                  1e-8 * stiffness(params).bend / (unit * unit));
    options.exactness = 0.7;
  }
  template <class F>
  auto with_energy(F&& f) {
    StretchEnergy stretch(params);
    JointEnergy joints(params);
    LoadEnergy load(params, loads);
    return f(EnergyTerms{stretch, joints, load});
  }
  double sideways() const { return rod.nodes.topRows<2>().colwise().norm().maxCoeff(); }

  RodParams params;
  double thrust;
  RodState rod;
  HeldUnknowns held;
  Loads loads;
  EquilibriumOptions options;
};

TEST(Stability, a_straight_strut_is_a_minimum_up_to_its_buckling_load_and_a_saddle_above) {
  for (const double unit : {1.0, 1e-9, 1e6}) {
    for (const double part : {0.97, 1.03}) {
      Strut strut(part, unit);
      SolverWork work;
      const Stability stability = strut.with_energy([&](const EnergyTerms& energy) {
        EXPECT_EQ(solve_equilibrium(strut.rod, strut.held, energy, strut.options).end,
                  EquilibriumEnd::converged);
        return stability_of(strut.rod, strut.held, energy, strut.options, work);
      });
      EXPECT_LT(strut.sideways(), 1e-6 * unit);  // by symmetry, also where that is no minimum
      EXPECT_EQ(stability.stable, part < 1) << part << " in units of " << unit;
      // against the Gauss-Newton matrix the curvature of the mode is 1 - load / buckling load
      const double expected = part > 1 ? 1 - part : 0;
      EXPECT_NEAR(stability.lowest_eigenvalue, expected, 0.2 * std::abs(expected));
    }
  }
}

TEST(Stability, the_softest_mode_of_a_strut_loses_its_stiffness_in_proportion_to_the_load) {
  for (const double part : {0.5, 0.9, 1.02}) {
    Strut strut(part);
    SolverWork work;
    strut.with_energy([&](const EnergyTerms& energy) {
      solve_equilibrium(strut.rod, strut.held, energy, strut.options);
      const CurvatureMode mode = softest_mode(strut.rod, strut.held, energy, strut.options, work);
      EXPECT_NEAR(mode.eigenvalue, 1 - part, 0.005) << part;
      // the quotient of the two quadratic forms in that direction
      const FrameChart chart(strut.rod, strut.held);
      const Eigen::SparseMatrix<double> exact = hessian(chart, energy);
      const double along =
          mode.direction.dot(exact.selfadjointView<Eigen::Lower>() * mode.direction);
      EXPECT_EQ(along > 0, part < 1);
    });
  }
}

TEST(Stability, a_search_leaves_the_saddle_for_the_buckled_shape) {
  Strut strut(1.05);
  const EquilibriumReport report = strut.with_energy([&](const EnergyTerms& energy) {
    return solve_stable_equilibrium(strut.rod, strut.held, energy, strut.options, 0.3);
  });
  EXPECT_EQ(report.end, EquilibriumEnd::converged);
  EXPECT_TRUE(report.stable);
  // elastica: at P / P_cr = (2 K(sin(alpha/2)) / pi)^2 = 1.05 the tip turns by 35.6 degrees and
  // moves sideways by 2 k / (K / L) with k = sin(alpha / 2)
  EXPECT_NEAR(strut.sideways() / 40, 0.380, 0.01);
}

}  // namespace
}  // namespace wirepack
