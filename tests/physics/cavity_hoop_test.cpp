#include <cmath>
#include <gtest/gtest.h>
#include <utility>

#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/load_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/energy/wall_energy.hpp"
#include "wirepack/observe/packing_density.hpp"
#include "wirepack/solve/equilibrium.hpp"

#include "../support/sample_rods.hpp"
#include "../support/strands.hpp"

namespace wirepack {
namespace {

using testing::ring_nodes;

// A wall and a wire that give way by 1/20000 of the radius of a coil under its own stiffness, for
// any size of the ball: near the closed forms, and not too stiff for the minimizer.
constexpr double firmness = 1e4;
double wall_stiffness(const RodParams& params, const Cavity& cavity) {
  return firmness * stiffness(params).bend / std::pow(cavity.radius - params.radius, 4);
}
WallEnergy firm_wall(const RodParams& params, const Cavity& cavity) {
  return {params, cavity, wall_stiffness(params, cavity)};
}
// The paper's wire but for its stretching stiffness, YA = firmness YI / rho^2.
RodParams paper_wire(double edge_length, double rho) {
  RodParams params;
  params.edge_length = edge_length;
  params.stretch_multiplier = firmness / (4 * rho * rho);
  return params;
}

EquilibriumOptions tight_options(const RodParams& params, double length) {
  const double bend = stiffness(params).bend;
  const double tolerance = 1e-6 * bend / (length * length);
  return {tolerance, tolerance * length, 1e-6 * bend, {}};
}

EquilibriumReport rest(RodState& state, const RodParams& params, const Cavity& cavity) {
  StretchEnergy stretch(params);
  JointEnergy joints(params);
  WallEnergy wall = firm_wall(params, cavity);
  EnergyTerms total{stretch, joints, wall};
  return solve_equilibrium(state, HeldUnknowns::none(state), total,
                           tight_options(params, cavity.radius));
}

TEST(HoopInBall, SmallerThanTheBallTouchesNoWallAndHasTheEnergyOfACircle) {
  const double radius = 6;
  double previous = 0;
  for (const Index edges : {50, 100, 200}) {
    const RodParams params = paper_wire(2 * pi * radius / static_cast<double>(edges), radius);
    RodState ring = make_rod(ring_nodes(radius, edges), params, RodEnds{.closed = true});
    const Cavity cavity{8};
    const EquilibriumReport report = rest(ring, params, cavity);
    EXPECT_EQ(report.end, EquilibriumEnd::converged);
    EXPECT_EQ(firm_wall(params, cavity).forces(ring).sum(), 0);
    const double error = report.energy / (pi * stiffness(params).bend / radius) - 1;
    EXPECT_LT(std::abs(error), 20 * std::pow(edges, -4));  // 7 / 720 turns^4 = 15.2 / N^4
    if (previous != 0) {
      EXPECT_NEAR(previous / error, 16, 0.2);  // order 4
    }
    previous = error;
  }
}

TEST(HoopInBall, LongerThanTheEquatorIsPressedByTheWallAllAround) {
  // slightly longer, so that the ring stays a circle: too stiff for so small a compression to bend
  const Cavity cavity{5};
  const double rho = 4;
  const Index edges = 100;
  const RodParams params = paper_wire(2 * pi * rho * 1.002 / static_cast<double>(edges), rho);
  RodState ring = make_rod(ring_nodes(rho, edges), params, RodEnds{.closed = true});
  const EquilibriumReport report = rest(ring, params, cavity);
  EXPECT_EQ(report.end, EquilibriumEnd::converged);
  const double length = total_rest_length(ring, params);
  const Eigen::VectorXd forces = firm_wall(params, cavity).forces(ring);
  EXPECT_NEAR(forces.minCoeff() / forces.maxCoeff(), 1, 1e-4);  // tolerance of rest
  // Radial balance at a node: the wall's force is 2 P sin(pi / N), P the compression of the wire.
  // Bending is measured per rest length, so that of a circle does not push outwards.
  const double radius = ring.nodes.col(0).norm();
  const double half_turn = pi / static_cast<double>(edges);
  const double perimeter = 2 * static_cast<double>(edges) * radius * std::sin(half_turn);
  const double compression = stiffness(params).stretch * (1 - perimeter / length);
  EXPECT_NEAR(forces[0] / (2 * compression * std::sin(half_turn)), 1, 1e-4);
  const double bend = joint_energies(params, ring).bend;
  EXPECT_NEAR(bend / (2 * pi * pi * stiffness(params).bend / length), 1, 7e-4);  // 6.6 / N^2
}

// A coil of this many edges along the equator, free at both ends, pressed by its stiffness alone.
double coil_energy(Index edges, const RodParams& params, const Cavity& cavity) {
  // Eshelby's force at a free end, B / (2 rho^2), is the compression of the coil, and the wall
  // holds it with B / (2 rho^3) per length.
  const double free = cavity.radius - params.radius;
  const double rho = free * (1 + 1 / (2 * firmness));
  const double step = params.edge_length / rho;
  Points nodes(3, edges + 1);
  for (Index i = 0; i <= edges; ++i) {
    const double angle = step * static_cast<double>(i);
    nodes.col(i) = Vec3(rho * std::cos(angle), rho * std::sin(angle), 0);
  }
  RodState coil = make_rod(nodes, params);
  const EquilibriumReport report = rest(coil, params, cavity);
  EXPECT_EQ(report.end, EquilibriumEnd::converged) << report.residual;
  return report.energy;
}

TEST(HoopInBall, CoilsAtTheWallCostAndPushAsTabulated) {
  // V4.2, a = 1, Y = 5: R, energy of a hoop, F R^2 / YI of a coil at the wall
  const double table[][3] = {{4, 4.112335, .888889},  {5, 3.084251, .781250},
                             {10, 1.370778, .617284}, {13, 1.028084, .586806},
                             {20, 0.649316, .554017}, {40, 0.316333, .525970},
                             {50, 0.251776, .520616}};
  for (const auto& [radius, hoop_energy, force] : table) {
    const Cavity cavity{radius};
    const Index per_turn = 120;
    const RodParams params =
        paper_wire(2 * pi * (radius - 1) / static_cast<double>(per_turn), radius - 1);
    // the ends unbend alike in both, so the difference is one more hoop at the wall
    const double hoop =
        coil_energy(3 * per_turn, params, cavity) - coil_energy(2 * per_turn, params, cavity);
    // nodes at the wall, turns x of pi / 60: curvature is off by x^2 / 24, and energy twice that;
    // the wall's overlap and the wire's compression change the radius by less than a thousandth
    EXPECT_NEAR(hoop / hoop_energy, 1, 2e-3) << radius;
    const double scaled_force =
        hoop / (2 * pi * (radius - 1)) * radius * radius / stiffness(params).bend;
    EXPECT_NEAR(scaled_force / force, 1, 2e-3) << radius;
  }
}

TEST(RodOnTheWall, SinksInByItsWeightOverTheStiffnessForAnyMesh) {
  // V3.3 on the floor of a sphere so wide that it is flat along the rod
  const Cavity cavity{1e6};
  const double weight = 0.1, floor_stiffness = 50;
  for (const Index edges : {5, 20, 40}) {
    const double length = 10;
    const RodParams params = paper_wire(length / static_cast<double>(edges), 10);
    Points nodes(3, edges + 1);
    for (Index i = 0; i <= edges; ++i) {
      nodes.col(i) =
          Vec3(length * (static_cast<double>(i) / static_cast<double>(edges) - 0.5), 0, 1 - 1e6);
    }
    RodState state = make_rod(nodes, params);
    WallEnergy wall(params, cavity, floor_stiffness);
    LoadEnergy load(params, Loads{.forces = {}, .moments = {}, .weight = Vec3(0, 0, -weight)});
    StretchEnergy stretch(params);
    JointEnergy joints(params);
    EnergyTerms total{stretch, joints, wall, load};
    const EquilibriumReport report =
        solve_equilibrium(state, HeldUnknowns::none(state), total, tight_options(params, 1));
    EXPECT_EQ(report.end, EquilibriumEnd::converged) << report.residual;
    const Eigen::VectorXd forces = wall.forces(state);
    const double per_node = weight * params.edge_length;
    // the floor bends down by 1.25e-5 at the ends, of an overlap of 2e-3
    for (Index i = 1; i < edges; ++i) EXPECT_NEAR(forces[i] / per_node, 1, 0.01) << edges;
    EXPECT_NEAR(forces[0] / (per_node / 2), 1, 0.01);
    EXPECT_NEAR(forces[edges] / (per_node / 2), 1, 0.01);
    for (Index i = 0; i <= edges; ++i) {
      EXPECT_NEAR(-wall_gap(cavity, state.nodes.col(i), 1) / (weight / floor_stiffness), 1, 0.01);
    }
    EXPECT_NEAR(forces.sum(), weight * length, 1e-3 * weight * length);  // tolerance of rest
  }
}

}  // namespace
}  // namespace wirepack
