#include "wirepack/packing/declared_units.hpp"

#include <gtest/gtest.h>

namespace wirepack {
namespace {

TEST(DeclaredUnits, thermal_energy_at_room_temperature_is_4_14_pN_nm) {
  EXPECT_NEAR(*thermal_energy(300, {"nm", "pN"}), 4.141947, 1e-6);
  EXPECT_NEAR(*thermal_energy(300, {"m", "N"}), 4.141947e-21, 1e-27);
  EXPECT_FALSE(thermal_energy(300, {}));
}

TEST(DeclaredUnits, forces_and_energies_are_shown_with_the_prefix_that_suits_them) {
  EXPECT_EQ(shown_force(0.00123, {"mm", "N"}), "1.23 mN");
  EXPECT_EQ(shown_force(0.284, {"nm", "pN"}), "0.284 pN");
  EXPECT_EQ(shown_force(-25000, {"mm", "kN"}), "-25 MN");
  EXPECT_EQ(shown_force(20, {"nm", "pN"}), "20 pN");
  EXPECT_EQ(shown_force(0, {"nm", "pN"}), "0 pN");
  EXPECT_EQ(shown_energy(5, {"mm", "N"}), "5 mJ");
  EXPECT_EQ(shown_energy(41.41947, {"nm", "pN"}), "10 k_B T (300 K)");
}

TEST(DeclaredUnits, without_names_a_number_is_in_units_of_the_configuration) {
  EXPECT_EQ(shown_force(0.5, {}), "0.5 (units of the configuration)");
}

}  // namespace
}  // namespace wirepack
