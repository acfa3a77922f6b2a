#include "wirepack/packing/warnings.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace wirepack {
namespace {

Scenario fine() {
  Scenario scenario = default_scenario(Setup::low_torsion, Cavity{10});
  scenario.stop.density = 0.2;
  return scenario;
}

std::vector<std::string> found(const Scenario& scenario) { return warnings(scenario, 260); }

void expect_one(const Scenario& scenario, const std::string& part) {
  const std::vector<std::string> all = found(scenario);
  ASSERT_EQ(all.size(), 1U) << part;
  EXPECT_NE(all.front().find(part), std::string::npos) << all.front();
}

TEST(Warnings, defaults_give_none) { EXPECT_EQ(found(fine()).size(), 0U); }

TEST(Warnings, a_rest_shape_tighter_than_the_wire_is_named_with_both_radii) {
  Scenario scenario = fine();
  scenario.wire.reference_shape.table = DarbouxTable({{0, Vec3(0, 2, 0)}, {20, Vec3(0, 2, 0)}});
  expect_one(scenario, "a radius of 0.5, tighter than its own, wire.radius = 1");
  scenario.wire.reference_shape.table = DarbouxTable({{0, Vec3(0, 0.9, 0)}, {20, Vec3::Zero()}});
  EXPECT_EQ(found(scenario).size(), 0U);
}

TEST(Warnings, a_shape_that_hardly_bends_over_the_cavity_is_asked_for_its_unit) {
  Scenario scenario = fine();
  scenario.wire.reference_shape.table = DarbouxTable({{0, Vec3(0, 3e-4, 0)}, {58e3, Vec3::Zero()}});
  expect_one(scenario, "are both in the same unit of length?");
}

TEST(Warnings, long_edges_are_compared_with_wire_and_cavity) {
  Scenario scenario = fine();
  scenario.wire.edge_length = 2.1;
  const std::vector<std::string> all = found(scenario);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_NE(all[0].find("is longer than the wire is thick, 2"), std::string::npos);
  EXPECT_NE(all[1].find("a fifth of cavity.radius, 2"), std::string::npos);
}

TEST(Warnings, few_frames_are_counted_at_the_expected_density) {
  Scenario scenario = fine();
  scenario.output.frame_every_density = 0.05;  // density 0.195
  expect_one(scenario, "fewer than 5 frames");
  scenario.output.frame_every_density = 0.048;
  EXPECT_EQ(found(scenario).size(), 0U);
}

TEST(Warnings, overlap_counts_from_three_tenths_of_the_radius_in_any_unit) {
  Scenario scenario = fine();
  scenario.wire.radius = 0.1;
  PackingProgress progress;
  progress.rod.nodes = Points::Zero(3, 3);
  progress.rod.nodes.row(0) << 0, 1, 2;
  EXPECT_EQ(warnings(scenario, progress, 0.029).size(), 0U);
  EXPECT_EQ(warnings(scenario, progress, 0.031).size(), 1U);
}

TEST(Warnings, coefficients_without_a_model_of_friction_are_told_to_have_no_effect) {
  Scenario scenario = fine();
  scenario.friction.static_coefficient = 0.5;
  expect_one(scenario, "friction.model is none");
  scenario.friction.model = FrictionModel::coulomb;
  EXPECT_EQ(found(scenario).size(), 0U);
}

}  // namespace
}  // namespace wirepack
