#include "wirepack/io/scenario_groups.hpp"

#include <gtest/gtest.h>

namespace wirepack {
namespace {

Scenario in_cavity(double radius, double contact_stiffness) {
  Scenario scenario = default_scenario(Setup::high_torsion, {radius});
  scenario.contact.stiffness = contact_stiffness;
  scenario.wall_stiffness = contact_stiffness;
  return scenario;
}

using Series = ScenarioGroups;

TEST(RadiusSeries, a_stiffness_of_contacts_for_each_radius_stays_in_one_series) {
  EXPECT_EQ(radius_series({in_cavity(10, 5), in_cavity(20, 1.25), in_cavity(20, 1.25)}),
            (Series{{0, 1, 2}}));
}

TEST(RadiusSeries, two_stiffnesses_of_contacts_at_one_radius_are_two_series) {
  EXPECT_EQ(radius_series({in_cavity(10, 5), in_cavity(20, 1.25), in_cavity(20, 5)}),
            (Series{{0, 2}, {1}}));
}

TEST(RadiusSeries, the_other_setup_is_a_series_of_its_own_and_its_stiffness_splits_no_other) {
  Scenario low = in_cavity(20, 5);
  low.setup = Setup::low_torsion;
  EXPECT_EQ(radius_series({low, in_cavity(10, 5), in_cavity(20, 1.25)}), (Series{{0}, {1, 2}}));
}

TEST(RadiusSeries, other_friction_is_another_series) {
  Scenario rough = in_cavity(20, 5);
  rough.friction.model = FrictionModel::coulomb;
  rough.friction.static_coefficient *= 2;
  EXPECT_EQ(radius_series({in_cavity(10, 5), rough}), (Series{{0}, {1}}));
}

}  // namespace
}  // namespace wirepack
