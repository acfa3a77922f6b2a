#include "wirepack/packing/own_units.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "wirepack/io/config_file.hpp"
#include "wirepack/packing/packing_run.hpp"

#include "../../support/scaled_scenario.hpp"

namespace wirepack {
namespace {

using testing::scaled_scenario;

// Every number that has a unit, none of them round.
Scenario crooked_scenario() {
  Scenario scenario = default_scenario(Setup::high_torsion, Cavity{11.7}, 1, 5, Method::dynamic);
  scenario.wire.edge_length = 0.7;
  scenario.density = 0.3;
  scenario.wall_stiffness = 17.0 / 3;
  scenario.contact.stiffness = 4.9;
  scenario.insertion.increment = 0.35;
  scenario.stop.length = 123.4567;
  scenario.dynamics.damping = 1e-3 / 7;
  scenario.dynamics.insertion_speed = 0.00731;
  scenario.dynamics.time_step = 0.0123;
  return scenario;
}

// As a configuration, which shows every number to the last bit.
std::string own_numbers(const Scenario& scenario) {
  return resolved_config(in_own_units(scenario));
}

TEST(OwnUnits, a_scenario_in_any_units_has_the_same_numbers_to_the_last_bit) {
  Scenario shaped = crooked_scenario();
  shaped.wire.rest_darboux.setZero();
  shaped.wire.reference_shape = {
      DarbouxTable({{0, Vec3(0.1, 0, 1.0 / 7)}, {20.3, Vec3(0.3, -0.1, 0)}}), BeyondShape::extend};
  for (const Scenario& scenario : {crooked_scenario(), shaped}) {
    const std::string own = own_numbers(scenario);
    for (const double length : {0x1p-40, 0x1p7, 1e-12, 1e-9, 1e-3, 125.0, 1e6, 1e12}) {
      for (const double modulus : {1e-30, 1e-9, 0x1p-3, 2.6e8, 1e30}) {
        for (const double density : {1e-27, 0x1p5, 1100.0}) {
          EXPECT_EQ(own_numbers(scaled_scenario(scenario, length, modulus, density)), own)
              << length << " " << modulus << " " << density;
        }
      }
    }
  }
}

TEST(OwnUnits, make_radius_modulus_and_density_one_and_keep_ratios) {
  const Scenario own = in_own_units(scaled_scenario(crooked_scenario(), 1e-9, 2.6e8, 1100));
  EXPECT_EQ(own.wire.radius, 1);
  EXPECT_EQ(own.wire.youngs_modulus, 1);
  EXPECT_EQ(own.density, 1);
  EXPECT_EQ(own.cavity.radius, 11.7);
  EXPECT_NEAR(own.wall_stiffness, 17.0 / 15, 1e-12);
  EXPECT_NEAR(own.wire.rest_darboux.y(), 1 / (2 * 11.7), 1e-12);
  const double time = std::sqrt(0.3 / 5);
  EXPECT_NEAR(*own.dynamics.time_step, 0.0123 / time, 1e-12);
  EXPECT_NEAR(*own.dynamics.insertion_speed, 0.00731 * time, 1e-12);
}

TEST(OwnUnits, a_valid_scenario_is_valid_in_them_at_its_limits) {
  Scenario scenario = default_scenario(Setup::low_torsion, Cavity{1000.0 / 3 * 3e-9}, 1e-9);
  scenario.wire.edge_length = 2e-9 / 3;
  scenario.insertion.increment = scenario.wire.edge_length / 1000;
  EXPECT_TRUE(problems(scenario).empty());
  EXPECT_TRUE(problems(in_own_units(scenario)).empty());
  scenario.cavity.radius = 1e-9 * 7 / 3;
  scenario.insertion.increment = scenario.wire.edge_length;
  EXPECT_TRUE(problems(in_own_units(scenario)).empty());
}

// As runs were computed before format version 2 of result files. Rest is met to within 1e-4 YI /
// R^2 in both, and energies go with the square of that.
template <class Packing>
void expect_the_same_progress_from_a_run_in_units_of_the_scenario(Scenario scenario) {
  scenario = scaled_scenario(scenario, 0x1p-4, 0x1p10, 0x1p6);
  Packing in_its_units(scenario);
  PackingRun in_own(scenario);
  for (int i = 0; i < 30; ++i) {
    in_its_units.advance();
    in_own.advance();
  }
  const PackingProgress converted = in_own_units(in_its_units.progress(), units_of(scenario));
  const PackingProgress& expected = in_own.progress();
  const auto near = [](double value, double exact) {
    return std::abs(value - exact) < 1e-5 * std::abs(exact) + 1e-9;
  };
  const auto near_vectors = [](const auto& value, const auto& exact) {
    return (value - exact).norm() < 1e-5 * exact.norm() + 1e-9;
  };
  EXPECT_TRUE(near_vectors(converted.rod.nodes, expected.rod.nodes));
  EXPECT_TRUE(near(converted.rod.inlet_rest_length, expected.rod.inlet_rest_length));
  for (const HistoryColumn& column : history_columns) {
    if (column.name == "residual" || column.name == "evaluations") continue;
    EXPECT_TRUE(near(converted.last.*column.value, expected.last.*column.value)) << column.name;
  }
  EXPECT_TRUE(near(converted.balance.work, expected.balance.work));
  EXPECT_TRUE(near(converted.balance.friction, expected.balance.friction));
  EXPECT_GT(expected.balance.friction, 1e-4);
  EXPECT_TRUE(near(converted.work_errors.trapezoid, expected.work_errors.trapezoid));
  ASSERT_EQ(converted.slip_memory.size(), expected.slip_memory.size());
  for (std::size_t i = 0; i < expected.slip_memory.size(); ++i) {
    EXPECT_TRUE(near_vectors(converted.slip_memory[i].spring, expected.slip_memory[i].spring));
    EXPECT_TRUE(near(converted.slip_memory[i].slid, expected.slip_memory[i].slid));
  }
  const ForceReading a = converted.recent_forces.back(), b = expected.recent_forces.back();
  EXPECT_TRUE(near(a.force, b.force));
  EXPECT_TRUE(near(a.inserted_length, b.inserted_length));
  ASSERT_EQ(converted.motion.has_value(), expected.motion.has_value());
  if (!expected.motion) {
    EXPECT_FALSE(expected.slip_memory.empty());
    return;
  }
  const MotionProgress& moving = *converted.motion;
  const MotionProgress& motion = *expected.motion;
  EXPECT_TRUE(near_vectors(moving.nodes, motion.nodes));
  EXPECT_TRUE(near_vectors(moving.spins, motion.spins));
  EXPECT_TRUE(near(moving.time, motion.time));
  EXPECT_TRUE(near(moving.flow.potential, motion.flow.potential));
  EXPECT_TRUE(near(moving.flow.kinetic, motion.flow.kinetic));
  EXPECT_TRUE(near(moving.flow.feed, motion.flow.feed));
  EXPECT_TRUE(near(moving.flow.injection_force, motion.flow.injection_force));
  ASSERT_FALSE(motion.friction.wall.empty());
  const StickAnchor touch = moving.friction.wall.front(), at = motion.friction.wall.front();
  EXPECT_TRUE(near(touch.normal_force, at.normal_force));
  EXPECT_TRUE(near_vectors(touch.spring, at.spring));
}

// Numbers of 13 digits at most, so that nothing is rounded.
Scenario round_scenario(Method method) {
  Scenario scenario = default_scenario(Setup::high_torsion, Cavity{4}, 1, 1, method);
  scenario.friction.model = FrictionModel::coulomb;
  scenario.contact.excluded_arc_length = 3;
  return scenario;
}

TEST(OwnUnits, a_progress_in_units_of_the_scenario_is_converted) {
  expect_the_same_progress_from_a_run_in_units_of_the_scenario<QuasistaticPacking>(
      round_scenario(Method::quasistatic));
  expect_the_same_progress_from_a_run_in_units_of_the_scenario<DynamicPacking>(
      round_scenario(Method::dynamic));
}

TEST(OwnUnits, what_is_found_comes_out_in_the_units_of_the_scenario) {
  const Units units{2, 3, 12, 10, 7};
  HistoryRow row;
  row.inserted_length = row.force = row.energy_bend = row.time = row.scaled_force = 1;
  row.wall_seconds = 1;
  row = in_units(row, units);
  EXPECT_EQ(row.inserted_length, 2);
  EXPECT_EQ(row.force, 12);
  EXPECT_EQ(row.energy_bend, 24);
  EXPECT_EQ(row.time, 4);
  EXPECT_EQ(row.scaled_force, 1);
  EXPECT_EQ(row.wall_seconds, 1);
  EXPECT_EQ(in_units(WorkBalance{.work = 1}, units).work, 24);
  PackingFrame frame;
  frame.rod.nodes = Points::Ones(3, 2);
  frame.wall_force = frame.bend_energy = frame.twist_energy = Eigen::VectorXd::Ones(2);
  frame.contacts.resize(1);
  frame.contacts[0].force = frame.contacts[0].overlap = 1;
  frame = in_units(frame, units);
  EXPECT_EQ(frame.rod.nodes(2, 1), 2);
  EXPECT_EQ(frame.wall_force[1], 12);
  EXPECT_EQ(frame.bend_energy[0], 24);
  EXPECT_EQ(frame.twist_energy[0], 24);
  EXPECT_EQ(frame.contacts[0].force, 12);
  EXPECT_EQ(frame.contacts[0].overlap, 2);
}

TEST(OwnUnits, an_unstable_integration_is_reported_in_the_units_of_the_scenario) {
  const UnstableIntegration failure(7, 3e-9, 1e-15);
  EXPECT_NE(std::string(failure.what()).find("L = 3e-09"), std::string::npos);
  EXPECT_NE(std::string(failure.what()).find("than 1e-15 may"), std::string::npos);
}

}  // namespace
}  // namespace wirepack
