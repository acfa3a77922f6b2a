#include "config_interpreter.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "config_keys.hpp"
#include "config_values.hpp"
#include "unknown_key.hpp"
#include "wire_stiffness.hpp"

namespace wirepack {

namespace {

std::string path_of(const GivenKey& given) { return given.section + "." + given.name; }

/// Turns given keys into a scenario and gathers what is wrong with them.
class Interpreter {
 public:
  Interpreter(const ConfigText& text, const std::string& source, std::vector<std::string>& problems)
      : text_(text), source_(source), problems_(problems) {}

  Configuration configuration() {
    check_sections();
    for (const GivenKey& given : text_.keys) accept(given);
    check_rest_shape();
    check_cavity();
    resolve_wire();
    result_.scenario = scenario();
    check_values();
    return std::move(result_);
  }

 private:
  struct Accepted {
    const ConfigKey* key;
    ConfigValue value;
  };

  const ConfigKey* find(std::string_view section, std::string_view name) const {
    const auto it = std::find_if(keys_.begin(), keys_.end(), [&](const ConfigKey& k) {
      return k.section == section && k.name == name;
    });
    return it == keys_.end() ? nullptr : &*it;
  }

  const GivenKey* given(std::string_view path) const {
    const auto it = std::find_if(text_.keys.begin(), text_.keys.end(),
                                 [&](const GivenKey& key) { return path_of(key) == path; });
    return it == text_.keys.end() ? nullptr : &*it;
  }

  const ConfigValue* value_of(std::string_view path) const {
    const auto it = std::find_if(accepted_.begin(), accepted_.end(),
                                 [&](const Accepted& a) { return a.key->path() == path; });
    return it == accepted_.end() ? nullptr : &it->value;
  }

  double number_or(std::string_view path, double otherwise) const {
    const ConfigValue* value = value_of(path);
    // Defaults are derived from possible values only; impossible ones are reported later.
    return value != nullptr && std::get<double>(*value) > 0 ? std::get<double>(*value) : otherwise;
  }

  std::string word_of(std::string_view path) const {
    const ConfigValue* value = value_of(path);
    return value == nullptr ? std::string() : std::get<std::string>(*value);
  }

  void complain(const GivenKey& key, const std::string& problem) {
    problems_.push_back(
        fmt::format("{}: {} = {}: {}", key.where, path_of(key), key.shown, problem));
  }

  void complain_about(std::string_view path, const std::string& problem) {
    if (const GivenKey* key = given(path)) complain(*key, problem);
  }

  void check_sections() {
    for (const GivenSection& section : text_.sections) {
      if (is_section(section.name, keys_)) continue;
      problems_.push_back(fmt::format("{}: [{}]: {}", section.where, section.name,
                                      unknown_section(section, keys_)));
    }
  }

  void accept(const GivenKey& key) {
    if (!is_section(key.section, keys_)) return;  // one message per section is enough
    const ConfigKey* known = find(key.section, key.name);
    if (known == nullptr) return complain(key, unknown_key(key, keys_));
    const std::filesystem::path folder = std::filesystem::path(source_).parent_path();
    std::string problem;
    std::optional<ConfigValue> value = converted(*known, key, folder, problem);
    if (!value) return complain(key, problem);
    accepted_.push_back({known, std::move(*value)});
    result_.given_keys.push_back(path_of(key));
    if (known->type != ConfigType::shape) return;
    if (const auto file = named_file(key, folder)) result_.inputs.push_back(*file);
  }

  // A wire has one shape at rest.
  void check_rest_shape() {
    const bool shaped = value_of("wire.reference_shape") != nullptr;
    if (shaped) {
      complain_about("wire.precurvature",
                     "wire.reference_shape is given, too; must be only one of them");
    } else {
      complain_about("wire.reference_shape_beyond",
                     "is for wire.reference_shape, which is not given");
    }
  }

  // A sphere has a radius, an ellipsoid semi-axes.
  void check_cavity() {
    if (given("cavity.shape") != nullptr && value_of("cavity.shape") == nullptr) return;
    if (word_of("cavity.shape") != "ellipsoid") {
      complain_about("cavity.semi_axes", "is for cavity.shape = \"ellipsoid\"");
      return;
    }
    complain_about("cavity.radius", "an ellipsoid has cavity.semi_axes in its place");
    if (given("cavity.semi_axes") == nullptr) {
      complain_about("cavity.shape", "needs cavity.semi_axes = [x, y, z]");
    }
  }

  // Puts the keys in place that others stand for.
  void resolve_wire() {
    GivenNumbers numbers;
    for (const Accepted& a : accepted_) {
      if (const auto* v = std::get_if<double>(&a.value)) numbers.emplace(a.key->path(), *v);
    }
    DeclaredUnits units{word_of("units.length"), word_of("units.force")};
    if ((given("units.length") == nullptr) != (given("units.force") == nullptr)) {
      complain_about(units.force.empty() ? "units.length" : "units.force",
                     "length and force are declared together; the other one is missing");
      return;
    }
    for (const KeyProblem& p : resolve_stiffness(numbers, units)) complain_about(p.path, p.problem);
    for (const char* name : {"radius", "youngs_modulus", "poisson_ratio", "stretch_multiplier"}) {
      const auto number = numbers.find(std::string("wire.") + name);
      if (number != numbers.end() && value_of(number->first) == nullptr) {
        accepted_.push_back({find("wire", name), number->second});
      }
    }
    result_.units = units;
  }

  Scenario defaults() const {
    const Scenario plain;
    Scenario chosen;
    for (const char* name : {"setup", "method"}) {
      const ConfigKey* key = find("packing", name);
      if (const ConfigValue* value = value_of(key->path())) key->set(chosen, *value);
    }
    Cavity cavity{number_or("cavity.radius", plain.cavity.radius)};
    if (const ConfigValue* axes = value_of("cavity.semi_axes")) {
      const Vec3& lengths = std::get<Vec3>(*axes);
      if (lengths.minCoeff() > 0) cavity = ellipsoid(lengths);
    }
    return default_scenario(chosen.setup, cavity, number_or("wire.radius", plain.wire.radius),
                            number_or("wire.youngs_modulus", plain.wire.youngs_modulus),
                            chosen.method);
  }

  Scenario scenario() const {
    Scenario result = defaults();
    const bool any_limit = std::any_of(accepted_.begin(), accepted_.end(),
                                       [](const Accepted& a) { return a.key->section == "stop"; });
    if (any_limit) result.stop = StopLimits{};
    for (const Accepted& a : accepted_) a.key->set(result, a.value);
    if (value_of("wire.edge_length") != nullptr && value_of("insertion.increment") == nullptr) {
      result.insertion.increment = result.wire.edge_length / 2;
    }
    return result;
  }

  void check_values() {
    std::vector<std::string> of_defaults;
    for (const std::string& problem : wirepack::problems(result_.scenario)) {
      const std::string_view path = std::string_view(problem).substr(0, problem.find(" = "));
      const GivenKey* key = given(path);
      if (key != nullptr && value_of(path) != nullptr) {
        problems_.push_back(key->where + ": " + problem);
      } else {
        of_defaults.push_back(source_ + ": " + problem + " (the default; give this key)");
      }
    }
    // A default that follows from a wrong value is not a problem of its own.
    if (problems_.empty()) problems_ = of_defaults;
  }

  const std::vector<ConfigKey> keys_ = config_keys();
  const ConfigText& text_;
  const std::string& source_;
  std::vector<std::string>& problems_;
  std::vector<Accepted> accepted_;
  Configuration result_;
};

}  // namespace

Configuration interpreted(const ConfigText& text, const std::string& source,
                          std::vector<std::string>& problems) {
  return Interpreter(text, source, problems).configuration();
}

}  // namespace wirepack
