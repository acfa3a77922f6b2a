#include <gtest/gtest.h>

#include "wirepack/core/error.hpp"
#include "wirepack/packing/equilibrate.hpp"
#include "wirepack/packing/quasistatic_packing.hpp"
#include "wirepack/packing/wire_in_nozzle.hpp"

namespace wirepack {
namespace {

Scenario small_run(Setup setup, FrictionModel friction) {
  Scenario scenario = default_scenario(setup, {4});
  scenario.wire.edge_length = 0.8;
  scenario.insertion.increment = 0.8;
  scenario.imperfection = {0.1, 0.9, 0.1};
  scenario.friction = {friction, 0.2, 0.18, 0.01};
  scenario.stop = {};
  scenario.stop.density = 0.45;
  return scenario;
}

struct Packed {
  HistoryRow row;
  PackingFrame frame;  ///< as a result file has it
};

Packed pack(const Scenario& scenario) {
  QuasistaticPacking packing(scenario);
  while (!packing.advance().stop) {
  }
  Packed packed{packing.progress().last, packing.take_frame()};
  RodState& rod = packed.frame.rod;
  rod.frames.resize(static_cast<std::size_t>(rod.edge_count()));
  rod.ends = {};
  rod.twist_guide.clear();
  rod.inlet_rest_length = 0;
  return packed;
}

double energy_of(PackingModel& model, const RodState& rod) {
  const Observation o = observe(model, rod);
  return o.energy_stretch + o.energy_bend + o.energy_twist + o.energy_wall + o.energy_contact;
}

double farthest_move(const RodState& before, const RodState& after) {
  return (after.nodes - before.nodes).colwise().norm().maxCoeff();
}

class RelaxedPacking : public ::testing::TestWithParam<Setup> {};

TEST_P(RelaxedPacking, a_saved_frame_has_the_length_and_the_energies_of_its_row) {
  const Scenario scenario = small_run(GetParam(), FrictionModel::coulomb);
  const Packed packed = pack(scenario);
  PackingModel model(scenario);
  const RodState rod = wire_in_nozzle(model, packed.frame);
  const Observation seen = observe(model, rod);
  // A free nozzle is at rest against the wire's rest curvature, and is read as untwisted.
  const double tolerance = GetParam() == Setup::high_torsion ? 1e-12 : 1e-6;
  EXPECT_NEAR(total_rest_length(rod, model.wire), packed.row.inserted_length, 1e-9);
  EXPECT_NEAR(seen.energy_bend / packed.row.energy_bend, 1, tolerance);
  EXPECT_NEAR(energy_of(model, rod) / packed.row.energy_total, 1, tolerance);
  EXPECT_GT(packed.row.energy_twist, 1e-3 * packed.row.energy_total);
  EXPECT_NEAR(seen.energy_twist / packed.row.energy_twist, 1, 100 * tolerance);
}

TEST_P(RelaxedPacking, without_friction_it_comes_to_a_minimum_of_less_energy_at_the_same_length) {
  Scenario scenario = small_run(GetParam(), FrictionModel::coulomb);
  const Packed packed = pack(scenario);
  scenario.friction.model = FrictionModel::none;
  PackingModel model(scenario);
  const RodState before = wire_in_nozzle(model, packed.frame);
  RodState rod = before;
  const Equilibrium found = equilibrate(model, before, rod);
  EXPECT_EQ(found.report.end, EquilibriumEnd::converged);
  EXPECT_TRUE(found.report.stable);
  EXPECT_LE(found.report.residual, 1);
  EXPECT_DOUBLE_EQ(total_rest_length(rod, model.wire), total_rest_length(before, model.wire));
  EXPECT_NEAR(found.report.energy / energy_of(model, rod), 1, 1e-9);
  EXPECT_LT(found.report.energy, 0.97 * energy_of(model, before));
  EXPECT_GT(farthest_move(before, rod), 0.1 * model.wire.radius);

  const RodState rest = rod;
  const Equilibrium again = equilibrate(model, rest, rod);
  EXPECT_LE(again.report.energy, found.report.energy * (1 + 1e-12));
  EXPECT_LT(farthest_move(rest, rod), 1e-3 * model.wire.radius);
}

TEST_P(RelaxedPacking, a_packing_without_friction_stays_where_it_is) {
  const Scenario scenario = small_run(GetParam(), FrictionModel::none);
  const Packed packed = pack(scenario);
  PackingModel model(scenario);
  const RodState before = wire_in_nozzle(model, packed.frame);
  RodState rod = before;
  const Equilibrium found = equilibrate(model, before, rod);
  EXPECT_EQ(found.report.end, EquilibriumEnd::converged);
  EXPECT_NEAR(found.report.energy / packed.row.energy_total, 1, 1e-6);
  EXPECT_LE(found.report.energy, energy_of(model, before) * (1 + 1e-12));
  // what the tolerance of the forces leaves free
  EXPECT_LT(farthest_move(before, rod), 0.01 * model.wire.radius);
}

INSTANTIATE_TEST_SUITE_P(Setups, RelaxedPacking,
                         ::testing::Values(Setup::low_torsion, Setup::high_torsion));

TEST(WireInNozzle, a_length_that_leaves_no_last_edge_and_too_few_frames_are_refused) {
  const Scenario scenario = default_scenario(Setup::low_torsion, {4});
  const PackingModel model(scenario);
  const RodState rod = initial_wire(model.nozzle, model.wire, 0.3);
  const std::vector<Quat> one{rod.frames.front()};
  EXPECT_THROW(wire_in_nozzle(model, rod.nodes, {}, model.wire.edge_length), InvalidInput);
  EXPECT_THROW(wire_in_nozzle(model, rod.nodes, one, 0.8), InvalidInput);
  EXPECT_DOUBLE_EQ(wire_in_nozzle(model, rod.nodes, {}, 0.8).inlet_rest_length,
                   0.8 - model.wire.edge_length);
}

}  // namespace
}  // namespace wirepack
