#include "wirepack/feed/feeder.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/rod/rod_strain.hpp"
#include "wirepack/solve/equilibrium.hpp"

#include "../../support/sample_rods.hpp"

namespace wirepack {
namespace {

RodParams params_with(double edge_length) {
  RodParams params;
  params.edge_length = edge_length;
  return params;
}

// A bent and twisted wire of length about `length` in a nozzle at the origin, at rest with its tip
// and the rotation of the tip held; the inlet edge is due for a split.
struct HeldWire {
  RodParams params;
  Nozzle nozzle{Vec3::Zero(), Vec3::UnitZ(), TwistCondition::locked};
  RodState rod;

  explicit HeldWire(double edge_length, double inlet_edges = 1.5)
      : params(params_with(edge_length)) {
    const auto edges = static_cast<Index>(std::lround(20 / edge_length));
    Points nodes(3, edges + 1);
    for (Index i = 0; i <= edges; ++i) {
      // an arc of radius 12 that ends in the nozzle
      const double angle = static_cast<double>(edges - i) * edge_length / 12;
      nodes.col(i) = 12 * Vec3(1 - std::cos(angle), 0, -std::sin(angle));
    }
    rod = make_rod(nodes, params, {.last_clamped = true});
    rod.inlet_rest_length = inlet_edges * edge_length;
    Quat& clamp = rod.frames.back();
    clamp = rotation_about(Vec3::UnitZ(), 1.0) * clamp;
    rod.twist_guide = joint_twists(rod);
    rest();
  }

  double rest() {
    HeldUnknowns held = held_by(nozzle, rod);
    held.hold_node(0);
    held.angle[0] = true;
    StretchEnergy stretch(params);
    JointEnergy joints(params);
    EnergyTerms energy{stretch, joints};
    MinimizerOptions method;
    const auto report = solve_equilibrium(rod, held, energy, {1e-9, 1e-9, 4e-6, method});
    EXPECT_EQ(report.end, EquilibriumEnd::converged);
    return report.energy;
  }
};

TEST(Feeder, InsertedLengthIsTheGrowthOfTheRestLength) {
  HeldWire wire(1);
  const double before = total_rest_length(wire.rod, wire.params);
  insert(wire.rod, 0.3);
  EXPECT_DOUBLE_EQ(total_rest_length(wire.rod, wire.params), before + 0.3);
}

double distance_to_wire(const Vec3& point, const RodState& rod) {
  double nearest = HUGE_VAL;
  for (Index j = 0; j < rod.edge_count(); ++j) {
    const Vec3 edge = rod.nodes.col(j + 1) - rod.nodes.col(j), from = point - rod.nodes.col(j);
    const double share = std::clamp(from.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (from - share * edge).norm());
  }
  return nearest;
}

TEST(Feeder, FedWireSlidesAlongItself) {
  HeldWire wire(1);
  const RodState before = wire.rod;
  insert(wire.rod, 0.5);
  check_state(wire.rod);
  EXPECT_EQ(Vec3(wire.rod.nodes.rightCols<1>()), Vec3(before.nodes.rightCols<1>()));
  EXPECT_EQ(Points(wire.rod.nodes.leftCols(11)), Points(before.nodes.leftCols(11)));
  for (Index i = 0; i + 1 < wire.rod.node_count(); ++i) {
    EXPECT_LT(distance_to_wire(wire.rod.nodes.col(i), before), 1e-12);
  }
}

TEST(Feeder, TenEdgesShareTheCompression) {
  const RodParams params = params_with(1);
  Points nodes = Points::Zero(3, 21);
  for (Index i = 0; i < 20; ++i) nodes(2, i) = static_cast<double>(i);
  nodes(2, 20) = 20.5;
  RodState rod = make_rod(nodes, params, {.last_clamped = true});
  rod.inlet_rest_length = 1.5;
  insert(rod, 0.5);
  const StretchEnergy stretch(params);
  Gradient gradient;
  set_zero(gradient, rod);
  const double energy = stretch.add_gradient(rod, gradient);
  // each edge is shorter by 0.05: nine of rest length 1, and the inlet edge of 2
  const double squares = 9 * 0.05 * 0.05 / 1 + 0.05 * 0.05 / 2;
  EXPECT_NEAR(energy, stiffness(params).stretch / 2 * squares, 1e-12);
}

TEST(Feeder, SplitIsDueAtTheLongestInletEdge) {
  HeldWire wire(1);
  wire.rod.inlet_rest_length = 1.1 - 1e-14;
  EXPECT_TRUE(split_is_due(wire.rod, 1.1));
  wire.rod.inlet_rest_length = 1.09;
  EXPECT_FALSE(split_is_due(wire.rod, 1.1));
}

TEST(Feeder, SplitKeepsLengthClampAndTotalTwistAndLeavesAdaptedFrames) {
  HeldWire wire(1);
  const double length = total_rest_length(wire.rod, wire.params);
  const Vec3 clamped = wire.rod.nodes.rightCols<1>();
  double twist = 0;
  for (const double t : joint_twists(wire.rod)) twist += t;
  const Index nodes = wire.rod.node_count();
  split_inlet(wire.rod, wire.nozzle, wire.params);
  EXPECT_EQ(wire.rod.node_count(), nodes + 1);
  EXPECT_EQ(wire.rod.frames.size(), static_cast<std::size_t>(nodes + 1));
  EXPECT_NEAR(total_rest_length(wire.rod, wire.params), length, 1e-12);
  EXPECT_EQ(Vec3(wire.rod.nodes.rightCols<1>()), clamped);
  check_state(wire.rod);
  double after = 0;
  for (const double t : joint_twists(wire.rod)) after += t;
  EXPECT_NEAR(twist, 1, 0.1);
  EXPECT_NEAR(after, twist, 0.01);  // the curve is planar: no holonomy but for the rounding of it
}

TEST(Feeder, EnergyJumpOfASplitVanishesWithTheMesh) {
  const auto jump = [](double edge_length) {
    HeldWire wire(edge_length);
    const double before = wire.rest();
    split_inlet(wire.rod, wire.nozzle, wire.params);
    return std::abs(wire.rest() / before - 1);
  };
  const double coarse = jump(1);
  const double fine = jump(0.5);
  EXPECT_LT(coarse, 0.01);
  EXPECT_LT(fine, coarse / 3);  // at least second order
}

// By the error of the mesh, x^3 / 36 + x^2 / 36 - x / 72 between a long inlet edge and one of its
// parts and a whole one: 1/6 of that of one and a half.
TEST(Feeder, ASplitThatLeavesAShortEdgeChangesLittleEnergy) {
  const auto jump = [](double inlet_edges) {
    HeldWire wire(1, inlet_edges);
    const double before = wire.rest();
    split_inlet(wire.rod, wire.nozzle, wire.params);
    return std::abs(wire.rest() / before - 1);
  };
  EXPECT_LT(jump(1.1), jump(1.5) / 4);
}

TEST(Feeder, SlidingOneEdgeMovesTheWireAlongItselfAndGoesOnWithItsCurvature) {
  HeldWire wire(0.5);
  const RodState before = wire.rod;
  RodState after = before;
  slide_one_edge(after, wire.params);
  check_state(after);
  const Index n = before.node_count();
  ASSERT_EQ(after.node_count(), n + 1);
  EXPECT_EQ(after.inlet_rest_length, before.inlet_rest_length);
  EXPECT_EQ((after.nodes.rightCols(n) - before.nodes).norm(), 0);
  const NodeEnergies was = node_energies(wire.params, before);
  const NodeEnergies is = node_energies(wire.params, after);
  // the old tip has become a joint, with the bending of the joint next to it and no more twist
  const double rounding = 1e-10;
  for (Index i = 1; i < n; ++i) {
    EXPECT_NEAR(is.bend[i + 1], was.bend[i], rounding);
    EXPECT_NEAR(is.twist[i + 1], was.twist[i], rounding);
  }
  EXPECT_NEAR(is.bend[1], was.bend[1], 1e-3 * was.bend[1]);
  const double length = (after.nodes.col(0) - after.nodes.col(1)).norm();
  EXPECT_NEAR(length, wire.params.edge_length, rounding);
}

}  // namespace
}  // namespace wirepack
