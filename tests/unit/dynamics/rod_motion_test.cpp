#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/core/error.hpp"
#include "wirepack/core/random.hpp"
#include "wirepack/core/rotation.hpp"
#include "wirepack/dynamics/damping.hpp"
#include "wirepack/dynamics/gear_integrator.hpp"
#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"

#include "../../support/clamped_rod.hpp"

namespace wirepack {
namespace {

constexpr double density = 1.3;

/// A wire that moves under its own elasticity, a drag and a gravity.
struct Wire {
  Wire(const RodState& rod, double step, const HeldUnknowns& held)
      : state(without_velocity(rod, step)), inertia(lumped_inertia(rod, params, density, held)) {
    start();
  }

  void set(Rates& out, const DynamicState& at) {
    EnergyTerms total{stretch, joints};
    set_zero(gradient, at.rod);
    elastic = total.add_gradient(at.rod, gradient);
    for (Index i = 0; i < inertia.mass.size(); ++i) {
      gradient.node.col(i) -= inertia.mass[i] * gravity;
    }
    set_motion(at, motion);
    set_rates(at, motion, inertia, gradient, out);
    if (drag > 0) add_damping(drag, at, motion, inertia, out);
  }
  void start() {
    set(rates, state);
    start_accelerations(state, rates);
    // The higher derivatives come by going to and fro from the same positions and velocities.
    const DynamicState initial = state;
    for (int sweep = 0; sweep < 12; ++sweep) {
      advance(4);
      reverse_time();
      advance(4);
      reverse_time();
      state.rod = initial.rod;
      state.nodes.leftCols<2>() = initial.nodes.leftCols<2>();
      state.spins.leftCols<2>() = initial.spins.leftCols<2>();
    }
    state.time = initial.time;
  }
  void reverse_time() {
    state.step = -state.step;
    for (const int k : {1, 3, 5}) {
      state.nodes.col(k) *= -1;
      state.spins.col(k) *= -1;
    }
  }
  void advance(std::int64_t steps) {
    const auto acceleration = [this](const DynamicState& at, Rates& out) { set(out, at); };
    for (std::int64_t k = 0; k < steps; ++k) gear_step(state, acceleration, rates);
  }
  double energy() {
    set(rates, state);
    return elastic + kinetic_energy(state, inertia);
  }

  RodParams params;
  StretchEnergy stretch{params};
  JointEnergy joints{params, stiffness(params)};
  double drag = 0, elastic = 0;
  Vec3 gravity = Vec3::Zero();
  DynamicState state;
  Inertia inertia;
  WireMotion motion;
  Gradient gradient;
  Rates rates;
};

/// A free wire, bent, thrown and spinning.
Wire thrown(double step) {
  Points nodes = testing::straight_nodes(8, 8);
  Random random(7);
  for (Index i = 0; i < nodes.size(); ++i) nodes.data()[i] += 0.05 * random.symmetric();
  const RodState rod = make_rod(nodes, RodParams{});
  Wire wire(rod, step, HeldUnknowns::none(rod));
  Points velocity(3, 9);
  for (Index i = 0; i < velocity.size(); ++i) velocity.data()[i] = 0.3 * random.symmetric();
  Eigen::VectorXd spin(8);
  for (Index j = 0; j < 8; ++j) spin[j] = 0.5 + 0.5 * random.symmetric();
  set_velocities(wire.state, velocity, spin);
  wire.start();
  return wire;
}

TEST(RodMotion, FreeFallIsExact) {
  const RodState rod = make_rod(testing::straight_nodes(4, 4), RodParams{});
  Wire wire(rod, 0.02, HeldUnknowns::none(rod));
  wire.gravity = Vec3(0.3, 0, -1);
  wire.start();
  wire.advance(500);
  const Points fallen =
      testing::straight_nodes(4, 4).colwise() + 50 * wire.gravity;          // g t^2 / 2, t = 10
  EXPECT_LT((wire.state.rod.nodes - fallen).cwiseAbs().maxCoeff(), 1e-10);  // round-off
}

struct Drift {
  double momentum, angular_momentum, energy;
};
Drift drift_until_20(double step) {
  Wire wire = thrown(step);
  const Vec3 momentum = linear_momentum(wire.state, wire.inertia);
  const Vec3 angular = angular_momentum(wire.state, wire.inertia);
  const double energy = wire.energy();
  EXPECT_GT(angular.norm(), 1);
  double spins = 0;
  for (Index j = 0; j < 8; ++j) spins += wire.inertia.spin[j] * wire.state.spin_rate(j);
  EXPECT_GT(spins, 1);  // so that leaving the spins or their gyroscopic couple out would show
  wire.advance(static_cast<std::int64_t>(std::round(20 / step)));
  return {(linear_momentum(wire.state, wire.inertia) - momentum).norm(),
          (angular_momentum(wire.state, wire.inertia) - angular).norm(),
          std::abs(wire.energy() - energy)};
}

TEST(RodMotion, AThrownSpinningWireKeepsItsMomentaAndItsEnergyToOrderFive) {
  const Drift coarse = drift_until_20(0.005), fine = drift_until_20(0.0025);
  EXPECT_LT(coarse.momentum, 1e-11);  // round-off, added up over 4000 steps
  EXPECT_LT(fine.angular_momentum, 1e-10);
  EXPECT_GT(std::log2(coarse.angular_momentum / fine.angular_momentum), 4.8);
  EXPECT_GT(std::log2(coarse.energy / fine.energy), 4.8);
}

TEST(RodMotion, FramesStayUnitAndOnTheirEdgesForAMillionSteps) {
  Wire wire = thrown(0.02);
  wire.advance(1000000);
  double norm = 0;
  for (const Quat& frame : wire.state.rod.frames) {
    norm = std::max(norm, std::abs(frame.norm() - 1));
  }
  set_motion(wire.state, wire.motion);
  double off = 0;
  for (Index j = 0; j < wire.state.rod.edge_count(); ++j) {
    off = std::max(off, (third_axis(wire.state.rod.frames[static_cast<std::size_t>(j)]) -
                         wire.motion.tangent.col(j))
                            .norm());
  }
  EXPECT_LT(norm, 1e-14);  // frames are normalized at every step
  EXPECT_LT(off, 1e-14);   // and carried to the tangent itself
}

// omega = (pi / 2L) c for a wave of speed c in a wire held at one end. Lumping makes it
// (2 / l) c sin(pi l / 4 L) exactly.
double held_frequency(double speed, Index edges) {
  return 2 * speed * std::sin(pi / (4 * static_cast<double>(edges)));
}

// Of an oscillation that starts at its extreme, from the first two times it crosses zero.
template <class Value>
double measured_frequency(Wire& wire, Value&& value) {
  double before = value(), first = -1;
  while (true) {
    wire.advance(1);
    const double now = value();
    if (before * now < 0) {
      const double crossed = wire.state.time - wire.state.step * now / (now - before);
      if (first > 0) return pi / (crossed - first);
      first = crossed;
    }
    before = now;
  }
}

TEST(RodMotion, AxialAndTorsionalFrequenciesOfAHeldWireAreExactForTheLumpedChain) {
  const Index edges = 10;
  const RodParams params;
  const testing::HeldRod start = testing::clamped_rod(edges, params, {.last_clamped = true});
  const RodState& rod = start.rod;
  RodState stretched = rod;
  for (Index i = 0; i <= edges; ++i) {
    stretched.nodes(2, i) -= 1e-6 * std::cos(pi / 2 * static_cast<double>(i) / edges);
  }
  Wire axial(stretched, 0.02, start.held);
  EXPECT_NEAR(
      measured_frequency(axial, [&] { return axial.state.rod.nodes(2, 0) - rod.nodes(2, 0); }),
      held_frequency(std::sqrt(params.youngs_modulus / density), edges), 1e-5);

  RodState twisted = rod;
  for (Index j = 0; j < edges; ++j) {
    const double angle = 1e-3 * std::cos(pi / 2 * (static_cast<double>(j) + 0.5) / edges);
    Quat& frame = twisted.frames[static_cast<std::size_t>(j)];
    frame = rotation_about(third_axis(frame), angle) * frame;
  }
  Wire torsional(twisted, 0.02, start.held);
  const double shear_modulus = params.youngs_modulus / (2 * (1 + params.poisson_ratio));
  const Quat rest = rod.frames.front();
  EXPECT_NEAR(
      measured_frequency(
          torsional, [&] { return (rest.conjugate() * torsional.state.rod.frames.front()).z(); }),
      held_frequency(std::sqrt(shear_modulus / density), edges), 1e-5);
}

// omega = beta^2 / L^2 sqrt(YI / rho A) with cos(beta) cosh(beta) = -1.
TEST(RodMotion, AClampedWireSwingsAtItsFirstTwoBendingFrequencies) {
  const Index edges = 40;
  const RodParams params;
  const double length = static_cast<double>(edges);
  const testing::HeldRod start = testing::clamped_rod(edges, params, {.last_clamped = true});
  for (const double beta : {1.875104, 4.694091}) {
    const double ratio = (std::cosh(beta) + std::cos(beta)) / (std::sinh(beta) + std::sin(beta));
    Points bent = start.rod.nodes;
    for (Index i = 0; i <= edges; ++i) {
      const double x = beta * (1 - static_cast<double>(i) / length);
      bent(0, i) = 1e-4 * (std::cosh(x) - std::cos(x) - ratio * (std::sinh(x) - std::sin(x)));
    }
    RodState rod = start.rod;
    rod.nodes = bent;
    carry_frames(rod);
    Wire wire(rod, 0.02, start.held);
    const double expected =
        beta * beta / (length * length) * std::sqrt(stiffness(params).bend / (density * pi));
    // the mesh: beta^2 / (12 edges^2) of joints and as much of lumped masses
    EXPECT_NEAR(measured_frequency(wire, [&] { return wire.state.rod.nodes(0, 0); }), expected,
                3e-3 * expected)
        << beta;
  }
}

TEST(RodMotion, AFallingWireEndsAtTheTerminalVelocityAndAMovingOneSlowsDown) {
  const RodState rod = make_rod(testing::straight_nodes(4, 4), RodParams{});
  Wire wire(rod, 0.02, HeldUnknowns::none(rod));
  wire.drag = 0.5;
  wire.gravity = Vec3(0, 0.2, 0);
  wire.start();
  wire.advance(5000);  // exp(-50) of the transient is left
  EXPECT_NEAR(wire.state.velocity(2).y(), 0.4, 1e-9);
  wire.gravity.setZero();
  wire.start();
  wire.advance(100);  // t = 2
  // the switch of gravity costs the scheme its order for a few steps
  EXPECT_NEAR(wire.state.velocity(2).y(), 0.4 * std::exp(-1), 1e-4);
}

TEST(RodMotion, an_edge_that_collapses_or_is_not_finite_is_named) {
  RodParams params;
  params.edge_length = 1;
  Points nodes = Points::Zero(3, 8);
  nodes.row(0) = Eigen::RowVectorXd::LinSpaced(8, 0, 7);
  for (const double place : {nodes(0, 5), std::nan("")}) {
    DynamicState state = without_velocity(make_rod(nodes, params), 0.01);
    state.nodes(18, 0) = place;  // x of node 6
    try {
      follow_nodes(state);
      ADD_FAILURE() << "was taken";
    } catch (const NumericalFailure& failure) {
      EXPECT_STREQ(failure.what(), "edge 5 has no length, or is not finite");
    }
  }
}

}  // namespace
}  // namespace wirepack
