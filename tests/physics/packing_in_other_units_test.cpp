#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "wirepack/packing/packing_run.hpp"

#include "../support/scaled_scenario.hpp"

namespace wirepack {
namespace {

using testing::scaled_scenario;

// Not yet a whole coil, in a small cavity.
Scenario small_scenario(Method method, FrictionModel friction) {
  Scenario scenario = default_scenario(Setup::high_torsion, Cavity{4}, 1, 5, method);
  scenario.friction.model = friction;
  scenario.imperfection = {0.1, 0.5, 0.1};
  scenario.stop = {};
  scenario.wire.edge_length = 1;
  scenario.stop.length = 20;
  return scenario;
}

std::vector<HistoryRow> history_of(const Scenario& scenario) {
  PackingRun packing(scenario);
  std::vector<HistoryRow> rows;
  for (bool going = true; going;) {
    const std::optional<StopReason> stop = packing.advance().stop;
    going = !stop;
    EXPECT_TRUE(!stop || *stop == StopReason::length);
    rows.push_back(packing.row());
  }
  return rows;
}

// Rows over the units that they should have.
std::vector<HistoryRow> scaled_back(std::vector<HistoryRow> rows, double length, double modulus,
                                    double density) {
  const double force = modulus * length * length, energy = force * length;
  for (HistoryRow& row : rows) {
    row.inserted_length /= length;
    row.max_overlap /= length;
    row.force /= force;
    row.force_difference /= force;
    row.time /= length * std::sqrt(density / modulus);
    for (double HistoryRow::*e :
         {&HistoryRow::energy_total, &HistoryRow::energy_stretch, &HistoryRow::energy_bend,
          &HistoryRow::energy_twist, &HistoryRow::energy_wall, &HistoryRow::energy_contact,
          &HistoryRow::snap_energy, &HistoryRow::friction_dissipation, &HistoryRow::energy_kinetic,
          &HistoryRow::viscous_dissipation, &HistoryRow::work}) {
      row.*e /= energy;
    }
  }
  return rows;
}

void expect_equal(const std::vector<HistoryRow>& rows, const std::vector<HistoryRow>& expected,
                  double tolerance) {
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const HistoryColumn& column : history_columns) {
      const double value = expected[i].*column.value;
      EXPECT_NEAR(rows[i].*column.value, value, tolerance * std::abs(value))
          << column.name << ", row " << i;
    }
  }
}

struct Kind {
  Method method;
  FrictionModel friction;
};

class PackingInOtherUnits : public ::testing::TestWithParam<Kind> {};

TEST_P(PackingInOtherUnits, is_the_same_run) {
  const Scenario scenario = small_scenario(GetParam().method, GetParam().friction);
  const std::vector<HistoryRow> expected = history_of(scenario);
  EXPECT_GT(expected.back().energy_bend, 0.5);
  const auto rows = [&](double length, double modulus, double density) {
    return scaled_back(history_of(scaled_scenario(scenario, length, modulus, density)), length,
                       modulus, density);
  };
  // to the last bit by powers of two (of four, for the square root in the unit of time)
  expect_equal(rows(0x1p-30, 0x1p40, 0x1p-20), expected, 0);
  // evaluations, too; converting rounds values
  expect_equal(rows(1e-12, 1e30, 1e-27), expected, 1e-14);
  expect_equal(rows(1e-9, 2.6e8, 1100), expected, 1e-14);
  expect_equal(rows(125, 1e-30, 1e3), expected, 1e-14);
  expect_equal(rows(1e12, 0.7, 1e-3), expected, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Ways, PackingInOtherUnits,
                         ::testing::Values(Kind{Method::quasistatic, FrictionModel::none},
                                           Kind{Method::quasistatic, FrictionModel::coulomb},
                                           Kind{Method::dynamic, FrictionModel::coulomb}));

}  // namespace
}  // namespace wirepack
