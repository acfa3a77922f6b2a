#include "config_keys.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "wirepack/core/error.hpp"
#include "wirepack/packing/declared_units.hpp"

#include "config_key_kinds.hpp"

namespace wirepack {

using namespace config;

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
constexpr std::array descent_names{std::pair{DescentMethod::nlopt_lbfgs, "nlopt_lbfgs"},
                                   std::pair{DescentMethod::compact_lbfgs, "compact_lbfgs"}};
constexpr std::array friction_names{std::pair{FrictionModel::none, "none"},
                                    std::pair{FrictionModel::coulomb, "coulomb"}};

constexpr std::string_view sphere_name = "sphere", ellipsoid_name = "ellipsoid";

template <class Access>
ConfigKey limit(std::string_view name, Access access) {
  return may_change(optional_value("stop", name, access));
}

ConfigKey cavity_shape() {
  ConfigKey key = named("cavity", "shape");
  key.type = ConfigType::choice;
  key.choices = {sphere_name, ellipsoid_name};
  key.set = [](Scenario&, const ConfigValue&) {};  // the keys of its sizes make it
  key.get = [](const Scenario& s) {
    return ConfigValue(std::string(s.cavity.semi_axes ? ellipsoid_name : sphere_name));
  };
  return key;
}

ConfigKey cavity_radius() {
  ConfigKey key = member("cavity", "radius", in(&Scenario::cavity, &Cavity::radius));
  key.get = [get = key.get](const Scenario& s) -> std::optional<ConfigValue> {
    if (s.cavity.semi_axes) return std::nullopt;
    return get(s);
  };
  return key;
}

ConfigKey semi_axes() {
  ConfigKey key = named("cavity", "semi_axes");
  key.type = ConfigType::vector;
  key.set = [](Scenario& s, const ConfigValue& v) { s.cavity = ellipsoid(std::get<Vec3>(v)); };
  key.get = [](const Scenario& s) -> std::optional<ConfigValue> {
    if (!s.cavity.semi_axes) return std::nullopt;
    return ConfigValue(*s.cavity.semi_axes);
  };
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
      cavity_shape(),
      cavity_radius(),
      semi_axes(),
      member("cavity", "wall_stiffness", in(&Scenario::wall_stiffness)),
      choice("nozzle", "twist", twist_names, in(&Scenario::nozzle, &NozzleOptions::twist)),
      optional_value("nozzle", "position", in(&Scenario::nozzle, &NozzleOptions::position)),
      optional_value("nozzle", "direction", in(&Scenario::nozzle, &NozzleOptions::direction)),
      member("nozzle", "depth", in(&Scenario::nozzle, &NozzleOptions::depth)),
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
      choice("minimizer", "method", descent_names,
             in(&Scenario::minimizer, &MinimizerOptions::method)),
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
      optional_value("dynamics", "damping", in(&Scenario::dynamics, &DynamicsOptions::damping)),
      optional_value("dynamics", "insertion_speed",
                     in(&Scenario::dynamics, &DynamicsOptions::insertion_speed)),
      or_auto(optional_value("dynamics", "time_step",
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
