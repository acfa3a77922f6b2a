#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/core/random.hpp"

#include "../support/moving_wire.hpp"
#include "../support/strain_of_turn.hpp"

namespace wirepack {
namespace {

using testing::MovingWire;

constexpr double density = 1;
constexpr double edge_length = 200;
constexpr double gravity = 0.1;
constexpr double degree = pi / 180;
// So large that its bottom is a plane: it turns by 1e-5 over the longest way here, and is higher
// under the ends of the wire by 1e-3 of the overlap.
constexpr double plane_radius = 1e9;

/// A straight, long wire of five nodes (friction acts a below its axis; on a short one that would
/// shift the load towards the front) at rest on the bottom of a huge cavity, along x. Gravity is
/// turned from -z towards +x by `slope`; the wire starts with the overlap that carries its weight.
MovingWire wire_on_plane(double slope, const StickSlipLaw& law, double step = 0.05) {
  WireForces forces;
  forces.wire.edge_length = edge_length;
  forces.cavity = Cavity{plane_radius};
  forces.friction = law;
  const double weight = gravity * density * pi;  // per length, a = 1
  forces.loads.weight = weight * Vec3(std::sin(slope), 0, -std::cos(slope));
  const double depth = plane_radius - 1 + weight * std::cos(slope) / forces.wall_stiffness;
  Points nodes(3, 5);
  for (Index i = 0; i < 5; ++i)
    nodes.col(i) = Vec3(edge_length * (static_cast<double>(i) - 2), 0, -depth);
  const RodState rod = make_rod(nodes, forces.wire);
  MovingWire wire(forces, density, HeldUnknowns::none(rod), rod, step);
  const double stretched = weight * std::sin(slope) / (law.stiffness_ratio * forces.wall_stiffness);
  for (Index i = 0; i < 5; ++i)
    wire.friction.wall.push_back({i, -1, Vec3(stretched, 0, 0), 0, false});
  return wire;
}

void set_velocity(MovingWire& wire, const Vec3& velocity) {
  Points all(3, 5);
  all.colwise() = velocity;
  set_velocities(wire.state, all, Eigen::VectorXd::Zero(4));
}

TEST(StickSlip, AWireOnAnInclineRestsBelowTheAngleOfStaticFriction) {
  const double limit = std::atan(0.2);
  MovingWire below = wire_on_plane(0.99 * limit, testing::paper_friction());
  below.advance_to(4000);
  EXPECT_LT(std::abs(below.mean_velocity(0)), 1e-6 * gravity * below.state.time);
  EXPECT_LT(std::abs(below.state.rod.nodes(0, 2)), 1e-6);
  MovingWire above = wire_on_plane(1.01 * limit, testing::paper_friction());
  above.advance_to(400);
  EXPECT_GT(above.state.rod.nodes(0, 2), 10);
}

TEST(StickSlip, AWireOnAnInclineSlidesWithTheDynamicCoefficientAboveIt) {
  for (const double angle : {15.0, 12.0}) {
    MovingWire wire = wire_on_plane(angle * degree, testing::paper_friction());
    wire.advance_to(100);
    const double before = wire.mean_velocity(0);
    wire.advance_to(300);
    const double expected = gravity * (std::sin(angle * degree) - 0.18 * std::cos(angle * degree));
    // the small rest of the swing on the wall
    EXPECT_NEAR((wire.mean_velocity(0) - before) / 200, expected, 1e-3 * expected) << angle;
  }
}

TEST(StickSlip, BetweenTheTwoAnglesAWireAtRestStaysAndAMovingOneGoesOn) {
  const double angle = 10.8 * degree;  // atan 0.18 = 10.20, atan 0.2 = 11.31
  MovingWire resting = wire_on_plane(angle, testing::paper_friction());
  resting.advance_to(1000);
  EXPECT_LT(std::abs(resting.mean_velocity(0)), 1e-5 * gravity * 1000);
  MovingWire moving = wire_on_plane(angle, testing::paper_friction());
  set_velocity(moving, Vec3(0.5, 0, 0));
  moving.advance_to(100);
  const double before = moving.mean_velocity(0);
  moving.advance_to(1000);
  const double gain = 900 * gravity * (std::sin(angle) - 0.18 * std::cos(angle));
  EXPECT_NEAR(moving.mean_velocity(0) - before, gain, 2e-3 * gain);
}

TEST(StickSlip, AThrownWireSlidesUntilItRollsAtTwoThirdsOfItsVelocity) {
  MovingWire wire = wire_on_plane(0, testing::paper_friction());
  const double start = 1;
  set_velocity(wire, Vec3(0, start, 0));
  const double rolls_after = start / (3 * 0.18 * gravity);  // 18.5
  wire.advance_to(0.5 * rolls_after);
  EXPECT_NEAR(wire.mean_velocity(1), start - 0.18 * gravity * wire.state.time, 1e-3 * start);
  wire.advance_to(3 * rolls_after);
  EXPECT_NEAR(wire.mean_velocity(1), 2.0 / 3 * start, 2e-3 * start);
  EXPECT_NEAR(wire.state.spin_rate(2), -2.0 / 3 * start, 2e-3 * start);  // over a = 1
}

TEST(StickSlip, WithoutFrictionAThrownWireGoesOnWithoutSpin) {
  StickSlipLaw none = testing::paper_friction();
  none.static_coefficient = none.dynamic_coefficient = 0;
  MovingWire wire = wire_on_plane(0, none);
  set_velocity(wire, Vec3(0, 0.1, 0));
  wire.advance_to(100);
  EXPECT_NEAR(wire.mean_velocity(1), 0.1, 1e-5);  // the bottom rises by 1e-5 on the way
  EXPECT_NEAR(wire.state.spin_rate(2), 0, 1e-15);
}

TEST(StickSlip,
     AnAxialPullBelowStaticFrictionMovesNothingAndAboveItGivesThePullLessDynamicFriction) {
  for (const double pull : {0.198, 0.5}) {  // over the normal force
    const double slope = std::atan(pull);
    MovingWire wire = wire_on_plane(slope, testing::paper_friction());
    wire.advance_to(100);
    const double before = std::sqrt(wire.motion.flow().kinetic);
    wire.advance_to(200);
    const double gain = std::sqrt(wire.motion.flow().kinetic) - before;
    const double mass = density * pi * 4 * edge_length, normal = gravity * std::cos(slope);
    const double expected = pull > 0.2 ? std::sqrt(mass / 2) * 100 * normal * (pull - 0.18) : 0.0;
    // a small swing of the load at first is left
    const double without_friction = std::sqrt(mass / 2) * 100 * normal * pull;
    EXPECT_NEAR(gain, expected, 1e-3 * expected + 1e-4 * without_friction) << pull;
  }
}

/// Three turns of a coil that rub on each other as they fly and spin.
MovingWire flying_coil(double step) {
  Random random(5);
  Points nodes(3, 80), velocity(3, 80);
  for (Index i = 0; i < nodes.cols(); ++i) {
    const double angle = 0.2 * static_cast<double>(i);
    nodes.col(i) = Vec3(5 * std::cos(angle), 5 * std::sin(angle), 0.305 * angle);
    velocity.col(i) = 0.02 * Vec3(random.symmetric(), random.symmetric(), random.symmetric()) +
                      Vec3(0.1, 0.01 * nodes(2, i), 0);
  }
  WireForces forces;
  forces.contact = ContactParams{};
  forces.friction = testing::paper_friction();
  const RodState rod = make_rod(nodes, forces.wire);
  MovingWire wire(forces, density, HeldUnknowns::none(rod), rod, step);
  set_velocities(wire.state, velocity, Eigen::VectorXd::Constant(79, 0.05));
  return wire;
}

struct Momenta {
  Vec3 linear, angular;
};
Momenta momenta_of(const MovingWire& wire) {
  return {linear_momentum(wire.state, wire.motion.inertia()),
          angular_momentum(wire.state, wire.motion.inertia())};
}

double angular_momentum_lost_until_20(double step) {
  MovingWire wire = flying_coil(step);
  const Momenta before = momenta_of(wire);
  double rubbed_off = 0;
  std::size_t most = 0;
  while (wire.state.time < 20 - step / 2) {
    wire.advance(1);
    rubbed_off += wire.state.step * wire.motion.flow().friction;
    most = std::max(most, wire.friction.strands.size());
  }
  EXPECT_GT(most, 40u);
  EXPECT_GT(rubbed_off, 0.1);
  const Momenta after = momenta_of(wire);
  // round-off, added up over thousands of steps
  EXPECT_LT((after.linear - before.linear).norm(), 1e-11 * before.linear.norm());
  return (after.angular - before.angular).norm() / before.angular.norm();
}

// Forces and moments on both partners are equal and opposite at every step, and linear momentum is
// kept by the scheme whatever they are. Angular momentum is kept to the order of the scheme, which
// contacts that close, stick and slide bring down from five to one.
TEST(StickSlip, StrandsThatRubOnEachOtherKeepMomentumAndAngularMomentum) {
  const double coarse = angular_momentum_lost_until_20(0.01);
  const double fine = angular_momentum_lost_until_20(0.0025);
  EXPECT_LT(fine, 1e-7);
  EXPECT_LT(fine, coarse / 3);
}

constexpr double circle_radius = 100;

/// Compressed along half a great circle by T1 at the tip and T2 at the other end, a wire rubs on
/// the wall like a rope on a bollard. Rest curvature leaves only the compression to press it on.
MovingWire wire_on_great_circle(Index turns, double ratio, double mu) {
  const double radius = circle_radius, turn = pi / static_cast<double>(turns);
  WireForces forces;
  forces.wire.edge_length = 2 * radius * std::sin(turn / 2);
  forces.wire.stretch_multiplier = 30;
  forces.wire.rest_darboux = Vec3(testing::strain_of_turn(turn) / forces.wire.edge_length, 0, 0);
  forces.cavity = Cavity{radius + 1};
  forces.friction = StickSlipLaw{mu, mu, 2.0 / 3, 0.05};
  forces.damping = 0.2;
  Points nodes(3, turns + 2);
  for (Index i = 0; i < turns + 2; ++i) {
    const double at = turn * static_cast<double>(i);
    nodes.col(i) = radius * Vec3(std::cos(at), std::sin(at), 0);
  }
  RodState rod = make_rod(nodes, forces.wire);
  // frames whose first axis is the normal of the plane
  Quat first;
  const Vec3 tangent = (nodes.col(1) - nodes.col(0)).normalized();
  Mat3 axes;
  axes << Vec3::UnitZ(), tangent.cross(Vec3::UnitZ()), tangent;
  first = Quat(axes);
  for (Index j = 0; j <= turns; ++j) {
    const double half = turn * static_cast<double>(j) / 2;
    rod.frames[static_cast<std::size_t>(j)] = Quat(std::cos(half), 0, 0, std::sin(half)) * first;
  }
  const double tension = 0.5;
  const Vec3 last = (nodes.col(turns + 1) - nodes.col(turns)).normalized();
  forces.loads.forces = {{0, tension * tangent}, {turns + 1, -ratio * tension * last}};
  // in the plane: sideways the compressed wire is not stable
  HeldUnknowns held = HeldUnknowns::none(rod);
  for (Index i = 0; i < turns + 2; ++i) held.coordinate[static_cast<std::size_t>(3 * i + 2)] = true;
  // and at its ends at the wall, from which a compressed end edge would turn away (half a circle)
  held.coordinate.front() = held.coordinate[static_cast<std::size_t>(3 * turns + 3)] = true;
  return {forces, density, held, rod, 0.05};
}

// T2 / T1 of a rope round equal turns D: [(1 + mu tan(D/2)) / (1 - mu tan(D/2))]^turns. Friction
// acts on the surface, a outside of the centreline, which gives its moment the lever rho + a.
double capstan_ratio(Index turns, double angle, double mu, double lever) {
  const double slope = mu * lever * std::tan(angle / static_cast<double>(turns) / 2);
  return std::pow((1 + slope) / (1 - slope), static_cast<double>(turns));
}

TEST(StickSlip, AWireRoundTheCavityHoldsUpToTheDiscreteCapstanRatioBothWays) {
  EXPECT_NEAR(capstan_ratio(16, pi, 0.2, 1), 1.878412, 1e-6);
  for (const auto& [turns, mu] : {std::pair{Index{16}, 0.2}, {Index{8}, 0.18}}) {
    const double ratio = capstan_ratio(turns, pi, mu, 1 + 1 / circle_radius);
    for (const double share : {0.99, 1.01}) {
      for (const bool inwards : {true, false}) {  // the larger force at one end or at the other
        MovingWire wire =
            wire_on_great_circle(turns, inwards ? share * ratio : 1 / (share * ratio), mu);
        wire.advance_to(1000);
        const double before = wire.state.rod.nodes(1, 0);
        wire.advance_to(1500);
        const double moved = std::abs(wire.state.rod.nodes(1, 0) - before);
        if (share < 1) {
          EXPECT_LT(moved, 1e-4) << turns << inwards;
        } else {
          EXPECT_GT(moved, 0.001) << turns << inwards;
        }
      }
    }
  }
}

}  // namespace
}  // namespace wirepack
