#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wirepack {

/// The names of the units of a configuration, if it has any. Reports use them, computations do not.
struct DeclaredUnits {
  std::string length;  ///< such as "mm"; empty: not declared
  std::string force;   ///< such as "mN"; given exactly when the length is
};

/// Names that a unit may have.
std::vector<std::string_view> length_unit_names();
std::vector<std::string_view> force_unit_names();

/// A unit in SI; nothing when it is not declared.
std::optional<double> in_metres(const DeclaredUnits& units);
std::optional<double> in_newtons(const DeclaredUnits& units);

/// Energy k_B T at a temperature [K], in the declared units; nothing when there are none.
std::optional<double> thermal_energy(double temperature, const DeclaredUnits& units);

/// A force or an energy of the configuration, such as "0.0123 (units of the configuration)", or
/// with declared units "0.123 N" (or another prefix, for large and small ones) and "4.56 uJ";
/// energies of molecules are over k_B T at 300 K.
std::string shown_force(double force, const DeclaredUnits& units);
std::string shown_energy(double energy, const DeclaredUnits& units);

}  // namespace wirepack
