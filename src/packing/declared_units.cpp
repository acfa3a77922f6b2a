#include "wirepack/packing/declared_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

namespace wirepack {

namespace {

using NamedUnit = std::pair<std::string_view, double>;

constexpr std::array<NamedUnit, 5> length_units{
    {{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}, {"nm", 1e-9}}};
constexpr std::array<NamedUnit, 6> force_units{
    {{"kN", 1e3}, {"N", 1}, {"mN", 1e-3}, {"uN", 1e-6}, {"nN", 1e-9}, {"pN", 1e-12}}};
constexpr std::array<NamedUnit, 8> prefixes{{{"M", 1e6},
                                             {"k", 1e3},
                                             {"", 1},
                                             {"m", 1e-3},
                                             {"u", 1e-6},
                                             {"n", 1e-9},
                                             {"p", 1e-12},
                                             {"f", 1e-15}}};

constexpr double boltzmann = 1.380649e-23;  // J / K, exact since 2019
constexpr double room_temperature = 300;    // K
constexpr double molecular = 1e-16;         // J

template <class Units>
std::vector<std::string_view> names_of(const Units& units) {
  std::vector<std::string_view> names;
  for (const NamedUnit& unit : units) names.push_back(unit.first);
  return names;
}

template <class Units>
std::optional<double> size_of(const std::string& name, const Units& units) {
  const auto unit = std::find_if(units.begin(), units.end(),
                                 [&](const NamedUnit& known) { return known.first == name; });
  return unit == units.end() ? std::nullopt : std::optional<double>(unit->second);
}

std::string number(double value) {
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}

// Between 1 and 1000 of the unit, where there is a prefix for that.
std::string with_prefix(double value, std::string_view unit) {
  const auto fits = [&](const NamedUnit& prefix) { return std::abs(value) >= prefix.second; };
  const auto* prefix = std::find_if(prefixes.begin(), prefixes.end(), fits);
  if (prefix == prefixes.end()) --prefix;
  return number(value / prefix->second) + " " + std::string(prefix->first) + std::string(unit);
}

std::string without_name(double value) { return number(value) + " (units of the configuration)"; }

}  // namespace

std::vector<std::string_view> length_unit_names() { return names_of(length_units); }
std::vector<std::string_view> force_unit_names() { return names_of(force_units); }

std::optional<double> in_metres(const DeclaredUnits& units) {
  return size_of(units.length, length_units);
}

std::optional<double> in_newtons(const DeclaredUnits& units) {
  return size_of(units.force, force_units);
}

std::optional<double> thermal_energy(double temperature, const DeclaredUnits& units) {
  const auto length = in_metres(units), force = in_newtons(units);
  if (!length || !force) return std::nullopt;
  return boltzmann * temperature / (*length * *force);
}

std::string shown_force(double force, const DeclaredUnits& units) {
  const auto unit = in_newtons(units);
  if (!unit) return without_name(force);
  const double size = std::abs(force);
  if (size == 0 || (size >= 0.01 && size < 1e4)) return number(force) + " " + units.force;
  return with_prefix(force * *unit, "N");
}

std::string shown_energy(double energy, const DeclaredUnits& units) {
  const auto thermal = thermal_energy(room_temperature, units);
  if (!thermal) return without_name(energy);
  if (energy == 0) return "0 J";
  const double joules = energy * *in_newtons(units) * *in_metres(units);
  if (std::abs(joules) < molecular) return number(energy / *thermal) + " k_B T (300 K)";
  return with_prefix(joules, "J");
}

}  // namespace wirepack
