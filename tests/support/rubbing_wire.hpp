#pragma once

#include <functional>
#include <gtest/gtest.h>
#include <vector>

#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/load_energy.hpp"
#include "wirepack/energy/slip_potential.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/energy/wall_energy.hpp"
#include "wirepack/solve/equilibrium.hpp"

namespace wirepack::testing {

/// A wire under dead loads on the wall of a sphere with friction, taken from rest to rest.
struct RubbingWire {
  RodParams params;
  Cavity cavity;
  FrictionParams friction;
  RodState rod;
  Loads loads = {};
  double tolerance = 1e-6;  ///< largest force left at rest
  std::vector<SlipMemory> memory = {};
  double dissipated = 0;
  Gradient gradient = {};  ///< at rest; what is not zero is held

  /// One increment: `change` moves what is held, or the loads, then all else goes to rest.
  void go(
      const HeldUnknowns& held, const std::function<void()>& change = [] {}) {
    StretchEnergy stretch(params);
    JointEnergy joints(params);
    WallEnergy wall(params, cavity, params.youngs_modulus);
    SlipPotential slip(params, cavity, friction);
    slip.start(rod, {}, wall.forces(rod), memory);
    change();
    LoadEnergy load(params, loads);
    EnergyTerms total{stretch, joints, wall, load, slip};
    EquilibriumOptions options{
        tolerance, tolerance * params.radius, 1e-6 * stiffness(params).bend, {}};
    const EquilibriumReport report = solve_equilibrium(rod, held, total, options);
    EXPECT_LE(report.residual, 1) << "after " << report.work.evaluations << " evaluations";
    memory = slip.memory(rod);
    dissipated += slip.work(rod).dissipated;
    set_zero(gradient, rod);
    total.add_gradient(rod, gradient);
    // moments on edges act as couples on their nodes
    const FrameChart chart(rod, HeldUnknowns::none(rod));
    Eigen::VectorXd by_x;
    chart.pull_back(rod, gradient.node, gradient.frame, by_x);
    for (Index i = 0; i < rod.node_count(); ++i) {
      gradient.node.col(i) = by_x.segment<3>(chart.unknown(i, 0));
    }
  }
};

}  // namespace wirepack::testing
