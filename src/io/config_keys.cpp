#include "config_keys.hpp"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include "wirepack/core/error.hpp"
#include "wirepack/packing/declared_units.hpp"

namespace wirepack {

namespace {

constexpr std::array setup_names{std::pair{Setup::low_torsion, "low_torsion"},
                                 std::pair{Setup::high_torsion, "high_torsion"}};
constexpr std::array beyond_names{std::pair{BeyondShape::error, "error"},
                                  std::pair{BeyondShape::repeat, "repeat"},
                                  std::pair{BeyondShape::extend, "extend"}};
constexpr std::array twist_names{std::pair{TwistCondition::free, "free"},
                                 std::pair{TwistCondition::locked, "locked"}};

constexpr std::array method_names{std::pair{Method::quasistatic, "quasistatic"},
                                  std::pair{Method::dynamic, "dynamic"}};
constexpr std::array friction_names{std::pair{FrictionModel::none, "none"},
                                    std::pair{FrictionModel::coulomb, "coulomb"}};

// Access to a member of a scenario, or to a member of a member.
template <class Member>
auto in(Member Scenario::*member) {
  return [=](auto& scenario) -> auto& { return scenario.*member; };
}
template <class Part, class Member>
auto in(Part Scenario::*part, Member Part::*member) {
  return [=](auto& scenario) -> auto& { return scenario.*part.*member; };
}

ConfigKey named(std::string_view section, std::string_view name) {
  ConfigKey key;
  key.section = section;
  key.name = name;
  return key;
}

// A key that stands for one member of the scenario; `access` gives a reference to it.
template <class Access>
ConfigKey member(std::string_view section, std::string_view name, Access access) {
  using Member = std::remove_reference_t<decltype(access(std::declval<Scenario&>()))>;
  ConfigKey key = named(section, name);
  if constexpr (std::is_same_v<Member, bool>) {
    key.type = ConfigType::boolean;
    key.set = [access](Scenario& s, const ConfigValue& v) { access(s) = std::get<bool>(v); };
    key.get = [access](const Scenario& s) { return ConfigValue(access(s)); };
  } else if constexpr (std::is_integral_v<Member>) {
    key.type = ConfigType::integer;
    key.smallest = std::is_unsigned_v<Member> ? 0 : std::numeric_limits<int>::min();
    key.largest = std::is_same_v<Member, int> ? std::numeric_limits<int>::max()
                                              : std::numeric_limits<std::int64_t>::max();
    key.set = [access](Scenario& s, const ConfigValue& v) {
      access(s) = static_cast<Member>(std::get<std::int64_t>(v));
    };
    key.get = [access](const Scenario& s) {
      return ConfigValue(static_cast<std::int64_t>(access(s)));
    };
  } else {
    key.set = [access](Scenario& s, const ConfigValue& v) { access(s) = std::get<double>(v); };
    key.get = [access](const Scenario& s) { return ConfigValue(access(s)); };
  }
  return key;
}

// A key without a value until it is given.
template <class Access>
ConfigKey optional_number(std::string_view section, std::string_view name, Access access) {
  using Value =
      typename std::remove_reference_t<decltype(access(std::declval<Scenario&>()))>::value_type;
  ConfigKey key = named(section, name);
  key.type = std::is_same_v<Value, double> ? ConfigType::number : ConfigType::integer;
  key.set = [access](Scenario& s, const ConfigValue& v) { access(s) = std::get<Value>(v); };
  key.get = [access](const Scenario& s) {
    const std::optional<Value> value = access(s);
    return value ? std::optional<ConfigValue>(*value) : std::nullopt;
  };
  return key;
}

ConfigKey may_change(ConfigKey key) {
  key.may_change = true;
  return key;
}

// A number, or the word that leaves it to the program.
ConfigKey or_auto(ConfigKey key) {
  key.choices = {"auto"};
  const auto set = key.set;
  key.set = [set](Scenario& s, const ConfigValue& v) {
    if (std::holds_alternative<double>(v)) set(s, v);
  };
  const auto get = key.get;
  key.get = [get](const Scenario& s) {
    const std::optional<ConfigValue> value = get(s);
    return value ? *value : ConfigValue(std::string("auto"));
  };
  return key;
}

template <class Access>
ConfigKey limit(std::string_view name, Access access) {
  return may_change(optional_number("stop", name, access));
}

template <class Names, class Access>
ConfigKey choice(std::string_view section, std::string_view name, const Names& names,
                 Access access) {
  ConfigKey key = named(section, name);
  key.type = ConfigType::choice;
  for (const auto& [value, text] : names) key.choices.emplace_back(text);
  key.set = [access, names](Scenario& s, const ConfigValue& v) {
    for (const auto& [value, text] : names) {
      if (std::get<std::string>(v) == text) access(s) = value;
    }
  };
  key.get = [access, names](const Scenario& s) {
    ConfigValue result;
    for (const auto& [value, text] : names) {
      if (access(s) == value) result = std::string(text);
    }
    return result;
  };
  return key;
}

// A choice that has one value only.
ConfigKey only(std::string_view section, std::string_view name, std::string_view value) {
  ConfigKey key = named(section, name);
  key.type = ConfigType::choice;
  key.choices = {value};
  key.set = [](Scenario&, const ConfigValue&) {};
  key.get = [value](const Scenario&) { return ConfigValue(std::string(value)); };
  return key;
}

ConfigKey precurvature() {
  ConfigKey key = named("wire", "precurvature");
  key.set = [](Scenario& s, const ConfigValue& v) {
    s.wire.rest_darboux = Vec3(0, std::get<double>(v), 0);
  };
  key.get = [](const Scenario& s) -> std::optional<ConfigValue> {
    if (!s.wire.reference_shape.empty()) return std::nullopt;
    const Vec3& k = s.wire.rest_darboux;
    if (k.x() != 0 || k.z() != 0) {
      throw InvalidInput(
          "wire.precurvature: only a rest curvature (0, k, 0) can be written as a configuration");
    }
    return ConfigValue(k.y());
  };
  return key;
}

// With what it holds and not by the name of a file: a run is the same whatever becomes of the file.
ConfigKey reference_shape() {
  ConfigKey key = named("wire", "reference_shape");
  key.type = ConfigType::shape;
  key.set = [](Scenario& s, const ConfigValue& v) {
    s.wire.reference_shape.table = DarbouxTable(std::get<std::vector<DarbouxRow>>(v));
    s.wire.rest_darboux.setZero();
  };
  key.get = [](const Scenario& s) -> std::optional<ConfigValue> {
    if (s.wire.reference_shape.empty()) return std::nullopt;
    return s.wire.reference_shape.table.rows();
  };
  return key;
}

ConfigKey reference_shape_beyond() {
  ConfigKey key = choice(
      "wire", "reference_shape_beyond", beyond_names,
      [](auto& s) -> auto& { return s.wire.reference_shape.beyond; });
  key.get = [get = key.get](const Scenario& s) -> std::optional<ConfigValue> {
    if (s.wire.reference_shape.empty()) return std::nullopt;
    return get(s);
  };
  return key;
}

// What only reading goes by: other keys follow from it, and it is never written.
ConfigKey stand_in(std::string_view section, std::string_view name) {
  ConfigKey key = named(section, name);
  key.set = [](Scenario&, const ConfigValue&) {};
  key.get = [](const Scenario&) -> std::optional<ConfigValue> { return std::nullopt; };
  return key;
}

// A name for reports.
ConfigKey unit(std::string_view name, std::vector<std::string_view> names) {
  ConfigKey key = stand_in("units", name);
  key.type = ConfigType::choice;
  key.choices = std::move(names);
  return key;
}

ConfigKey seed() {
  ConfigKey key = member("packing", "seed", in(&Scenario::seed));
  key.get = [](const Scenario& s) {
    if (s.seed > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
      throw InvalidInput("packing.seed: TOML has no integers above 2^63 - 1");
    }
    return ConfigValue(static_cast<std::int64_t>(s.seed));
  };
  return key;
}

}  // namespace

std::vector<ConfigKey> config_keys() {
  return {
      choice("packing", "setup", setup_names, in(&Scenario::setup)),
      choice("packing", "method", method_names, in(&Scenario::method)),
      seed(),
      unit("length", length_unit_names()),
      unit("force", force_unit_names()),
      member("wire", "radius", in(&Scenario::wire, &RodParams::radius)),
      member("wire", "youngs_modulus", in(&Scenario::wire, &RodParams::youngs_modulus)),
      member("wire", "poisson_ratio", in(&Scenario::wire, &RodParams::poisson_ratio)),
      member("wire", "stretch_multiplier", in(&Scenario::wire, &RodParams::stretch_multiplier)),
      member("wire", "edge_length", in(&Scenario::wire, &RodParams::edge_length)),
      precurvature(),
      reference_shape(),
      reference_shape_beyond(),
      member("wire", "density", in(&Scenario::density)),
      stand_in("wire", "bending_stiffness"),
      stand_in("wire", "torsional_stiffness"),
      stand_in("wire", "persistence_length"),
      stand_in("wire", "temperature"),
      stand_in("wire.coil", "wire_diameter"),
      stand_in("wire.coil", "coil_diameter"),
      stand_in("wire.coil", "youngs_modulus"),
      stand_in("wire.coil", "poisson_ratio"),
      only("cavity", "shape", "sphere"),
      member("cavity", "radius", in(&Scenario::cavity, &Cavity::radius)),
      member("cavity", "wall_stiffness", in(&Scenario::wall_stiffness)),
      choice("nozzle", "twist", twist_names, in(&Scenario::nozzle_twist)),
      member("contact", "enabled", in(&Scenario::contact_enabled)),
      member("contact", "stiffness", in(&Scenario::contact, &ContactParams::stiffness)),
      member("contact", "excluded_arc_length",
             in(&Scenario::contact, &ContactParams::excluded_arc_length)),
      member("insertion", "increment", in(&Scenario::insertion, &InsertionOptions::increment)),
      member("insertion", "perturbation",
             in(&Scenario::insertion, &InsertionOptions::perturbation)),
      limit("scaled_force", in(&Scenario::stop, &StopLimits::scaled_force)),
      limit("force", in(&Scenario::stop, &StopLimits::force)),
      limit("density", in(&Scenario::stop, &StopLimits::density)),
      limit("length", in(&Scenario::stop, &StopLimits::length)),
      limit("increments", in(&Scenario::stop, &StopLimits::increments)),
      member("minimizer", "tolerance", in(&Scenario::minimizer, &MinimizerOptions::tolerance)),
      member("minimizer", "max_evaluations",
             in(&Scenario::minimizer, &MinimizerOptions::max_evaluations)),
      member("minimizer", "memory", in(&Scenario::minimizer, &MinimizerOptions::memory)),
      member("minimizer", "refactor_every",
             in(&Scenario::minimizer, &MinimizerOptions::refactor_every)),
      member("minimizer", "shift", in(&Scenario::minimizer, &MinimizerOptions::shift)),
      choice("friction", "model", friction_names, in(&Scenario::friction, &FrictionParams::model)),
      member("friction", "static", in(&Scenario::friction, &FrictionParams::static_coefficient)),
      member("friction", "dynamic", in(&Scenario::friction, &FrictionParams::dynamic_coefficient)),
      member("friction", "slip_tolerance",
             in(&Scenario::friction, &FrictionParams::slip_tolerance)),
      optional_number("dynamics", "damping", in(&Scenario::dynamics, &DynamicsOptions::damping)),
      optional_number("dynamics", "insertion_speed",
                      in(&Scenario::dynamics, &DynamicsOptions::insertion_speed)),
      or_auto(optional_number("dynamics", "time_step",
                              in(&Scenario::dynamics, &DynamicsOptions::time_step))),
      member("imperfection", "natural_curvature",
             in(&Scenario::imperfection, &ImperfectionOptions::natural_curvature)),
      member("imperfection", "nozzle_offset",
             in(&Scenario::imperfection, &ImperfectionOptions::nozzle_offset)),
      member("imperfection", "nozzle_tilt",
             in(&Scenario::imperfection, &ImperfectionOptions::nozzle_tilt)),
      may_change(member("output", "frame_every_density",
                        in(&Scenario::output, &OutputOptions::frame_every_density))),
      may_change(member("output", "checkpoint_every_seconds",
                        in(&Scenario::output, &OutputOptions::checkpoint_every_seconds))),
  };
}

bool is_section(std::string_view name, const std::vector<ConfigKey>& keys) {
  return std::any_of(keys.begin(), keys.end(),
                     [&](const ConfigKey& key) { return key.section == name; });
}

}  // namespace wirepack
