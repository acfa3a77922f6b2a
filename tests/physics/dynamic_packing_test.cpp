#include "wirepack/packing/dynamic_packing.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/core/error.hpp"
#include "wirepack/packing/dynamics_values.hpp"
#include "wirepack/packing/quasistatic_packing.hpp"

#include "../support/moving_wire.hpp"

namespace wirepack {
namespace {

Scenario scenario_of(Setup setup, double radius, Method method, double length) {
  Scenario scenario = default_scenario(setup, Cavity{radius}, 1, 5, method);
  scenario.stop = {};
  scenario.stop.length = length;
  return scenario;
}

template <class Packing, class Each>
void run(Packing& packing, Each&& each) {
  while (!packing.advance().stop) each(packing.progress().last);
}

struct Means {
  double force = 0, bend_energy = 0;
  int count = 0;
  void add(const HistoryRow& row) {
    force += row.scaled_force;
    bend_energy += row.energy_bend;
    ++count;
  }
};

TEST(DynamicPacking, WithoutFrictionEnergyAndForceAreThoseOfTheMinimization) {
  const double length = 20;  // phi = 0.12
  Scenario moving = scenario_of(Setup::low_torsion, 5, Method::dynamic, length);
  moving.friction.model = FrictionModel::none;
  Means dynamic, minimal;
  // once the first coil has formed
  const auto into = [](Means& means) {
    return [&means](const HistoryRow& row) {
      if (row.inserted_length > 14) means.add(row);
    };
  };
  DynamicPacking in_time(moving);
  run(in_time, into(dynamic));
  QuasistaticPacking minimizing(scenario_of(Setup::low_torsion, 5, Method::quasistatic, length));
  run(minimizing, into(minimal));
  ASSERT_GT(std::min(dynamic.count, minimal.count), 20);
  EXPECT_NEAR(dynamic.bend_energy / dynamic.count / (minimal.bend_energy / minimal.count), 1, 0.01);
  // a few per cent for the energy that vibrations take
  EXPECT_NEAR(dynamic.force / dynamic.count / (minimal.force / minimal.count), 1, 0.03);
  EXPECT_LT(std::abs(in_time.progress().last.audit_residual), 1e-3);
}

TEST(DynamicPacking, WithFrictionTheWorkIsAccountedForAndTheForceIsAboveTheChangeOfEnergy) {
  Scenario scenario = scenario_of(Setup::high_torsion, 5, Method::dynamic, 24);
  DynamicPacking packing(scenario);
  double rubbed_off = 0, work = 0;
  run(packing, [&](const HistoryRow& row) {
    EXPECT_GE(row.viscous_dissipation, 0);
    // springs of contacts that close and open give and take a little
    EXPECT_GT(row.friction_dissipation, -1e-3 * std::abs(row.work)) << row.increment;
    rubbed_off += row.friction_dissipation;
    work += row.work;
  });
  const PackingProgress& end = packing.progress();
  EXPECT_LT(std::abs(end.last.audit_residual), 1e-3);
  EXPECT_GT(rubbed_off, 0.1 * work);
  EXPECT_GT(work, end.last.energy_total);
  EXPECT_LT(end.last.energy_kinetic, 0.02 * end.last.energy_total);
}

TEST(DynamicPacking, StiffContactsThatStickKeepTheEnergy) {
  Scenario scenario = scenario_of(Setup::high_torsion, 4, Method::dynamic, 14);
  scenario.wall_stiffness = scenario.contact.stiffness = 16 * scenario.wire.youngs_modulus;
  DynamicPacking packing(scenario);
  run(packing, [](const HistoryRow&) {});
  EXPECT_LT(std::abs(packing.progress().last.audit_residual), 0.01);
}

TEST(DynamicPacking, ARunThatGoesOnFromASavedProgressEndsInTheSameBits) {
  const Scenario scenario = scenario_of(Setup::low_torsion, 5, Method::dynamic, 12);
  DynamicPacking straight(scenario);
  std::optional<PackingProgress> saved;
  run(straight, [&](const HistoryRow& row) {
    if (row.increment == 38) saved = straight.progress();
  });
  ASSERT_TRUE(saved);
  DynamicPacking resumed(scenario, *saved);
  run(resumed, [](const HistoryRow&) {});
  const PackingProgress &a = straight.progress(), &b = resumed.progress();
  EXPECT_EQ(a.last.energy_total, b.last.energy_total);
  EXPECT_EQ(a.last.work, b.last.work);
  EXPECT_TRUE((a.rod.nodes.array() == b.rod.nodes.array()).all());
  EXPECT_TRUE((a.motion->nodes.array() == b.motion->nodes.array()).all());
  EXPECT_EQ(a.motion->friction.wall.size(), b.motion->friction.wall.size());
}

TEST(DynamicPacking, ARunGoesOnWithAnotherStepAtTheSameVelocities) {
  Scenario scenario = scenario_of(Setup::low_torsion, 5, Method::dynamic, 10);
  DynamicPacking before(scenario);
  run(before, [](const HistoryRow&) {});
  scenario.stop.length = 10.5;
  const HistoryRow same = DynamicPacking(scenario, before.progress()).advance().row.value();
  scenario.dynamics.time_step = dynamics_values(scenario).time_step / 3;
  DynamicPacking changed(scenario, before.progress());
  // saved and gone on with again, before its next increment
  const HistoryRow other = DynamicPacking(scenario, changed.progress()).advance().row.value();
  EXPECT_NEAR(other.energy_kinetic / same.energy_kinetic, 1, 0.05);
  EXPECT_NEAR(other.energy_total / same.energy_total, 1, 1e-3);
  EXPECT_LT(std::abs(other.audit_residual), 1e-3);
}

TEST(DynamicPacking, a_wire_a_hundred_times_as_stiff_in_torsion_as_in_bending_stays_stable) {
  Scenario scenario = scenario_of(Setup::high_torsion, 5, Method::dynamic, 10);
  scenario.wire.edge_length = 1;
  scenario.wire.poisson_ratio = -0.99;
  DynamicPacking packing(scenario);
  EXPECT_NO_THROW(run(packing, [](const HistoryRow&) {}));
  EXPECT_LT(std::abs(packing.progress().last.audit_residual), 5e-3);
}

TEST(DynamicPacking, strong_damping_takes_shorter_steps_and_leaves_the_force_finite) {
  Scenario scenario = scenario_of(Setup::low_torsion, 4, Method::dynamic, 8);
  scenario.dynamics.damping = 30;
  DynamicPacking packing(scenario);
  EXPECT_NO_THROW(run(packing, [](const HistoryRow&) {}));
  EXPECT_LT(std::abs(packing.progress().last.audit_residual), 5e-3);
}

TEST(DynamicPacking, AStepBeyondStabilityIsRefusedWithAReason) {
  Scenario scenario = scenario_of(Setup::low_torsion, 5, Method::dynamic, 12);
  scenario.dynamics.time_step = 1 / dynamics_values(scenario).highest_frequency;
  try {
    DynamicPacking packing(scenario);
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("dynamics.time_step = "), std::string::npos);
  }
}

/// kL at the Euler load of a wire of length L that is clamped at one end and sticks with a round
/// tip of radius a at the other, at the wall of a sphere of radius rho of centrelines: the smallest
/// root of the determinant for y = A (sin kx - kx) + C (cos kx - 1) with y + a y' = 0 (the tip
/// rolls) and y'' + a (y''' + k^2 y') + a^2 k^2 / rho y' = 0 (moment of the sticking force, and the
/// slope of the wall) at L. For a = 0 that is tan kL = kL, 4.4934.
double critical_kl(double length, double a, double rho) {
  const auto determinant = [&](double kl) {
    const double k = kl / length, s = std::sin(kl), c = std::cos(kl);
    const auto rolls = [&](double y, double y1) { return y + a * y1; };
    const auto moment = [&](double y1, double y2, double y3) {
      return y2 + a * (y3 + k * k * y1) + a * a * k * k / rho * y1;
    };
    return rolls(s - kl, k * (c - 1)) * moment(-k * s, -k * k * c, k * k * k * s) -
           rolls(c - 1, -k * s) * moment(k * (c - 1), -k * k * s, -k * k * k * c);
  };
  double low = pi, high = 1.6 * pi;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    ((determinant(middle) > 0) == (determinant(low) > 0) ? low : high) = middle;
  }
  return low;
}

/// A straight, compressed wire between the nozzle and the far pole of a cavity, whose tip sticks.
testing::MovingWire strut(double share_of_critical) {
  const double radius = 10, a = 1;
  const Index edges = 18;
  WireForces forces;
  forces.wire.stretch_multiplier = 30;  // so that what it stands is that of an inextensible wire
  forces.cavity = Cavity{radius};
  forces.wall_stiffness = 50;
  forces.friction = StickSlipLaw{20, 20, 1, 0.05};
  forces.damping = 0.002;
  const Stiffness stiff = stiffness(forces.wire);
  const double length = 2 * (radius - a);
  const double k = critical_kl(length, a, radius - a) / length;
  const double load = share_of_critical * stiff.bend * k * k;
  const double overlap = load / (forces.wall_stiffness * 2 * a);  // the tip touches with a point
  const double edge = (length + overlap) / static_cast<double>(edges);
  forces.wire.edge_length = edge / (1 - load / stiff.stretch);
  Points nodes = Points::Zero(3, edges + 1);
  for (Index i = 0; i <= edges; ++i)
    nodes(2, i) = -(radius - a) - overlap + edge * static_cast<double>(i);
  RodState rod = make_rod(nodes, forces.wire, {.last_clamped = true});
  HeldUnknowns held = HeldUnknowns::none(rod);
  held.hold_node(edges);
  testing::MovingWire wire(forces, 1, held, rod, 0.01);
  Points velocity = Points::Zero(3, edges + 1);
  for (Index i = 1; i < edges; ++i) velocity(0, i) = 1e-5;
  set_velocities(wire.state, velocity, Eigen::VectorXd::Zero(wire.state.spins.rows()));
  return wire;
}

TEST(DynamicPacking, AWireWhoseTipSticksAtTheFarPoleBucklesAtTheEulerLoad) {
  EXPECT_NEAR(critical_kl(18, 1e-9, 9), 4.493409, 1e-5);
  for (const double share : {0.97, 1.03}) {
    testing::MovingWire wire = strut(share);
    wire.advance_to(1500);
    const double off = wire.state.rod.nodes.row(0).cwiseAbs().maxCoeff();
    EXPECT_EQ(off > 0.01, share > 1) << off;  // the kick itself swings by 5e-4
  }
}

}  // namespace
}  // namespace wirepack
