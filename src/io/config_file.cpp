#include "wirepack/io/config_file.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

#include "wirepack/core/error.hpp"
#include "wirepack/io/shape_file.hpp"

#include "config_keys.hpp"
#include "config_text.hpp"
#include "number_hint.hpp"
#include "text_file.hpp"
#include "wire_stiffness.hpp"

namespace wirepack {

namespace {

constexpr std::size_t largest_file = 1'000'000;
constexpr std::size_t most_problems = 50;

// Levenshtein distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

// The candidate that was probably meant, or nothing.
std::string nearest(std::string_view given, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t least = std::max<std::size_t>(2, given.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(given, candidate);
    if (distance < least && distance < candidate.size()) {
      least = distance;
      best = candidate;
    }
  }
  return best;
}

std::string quoted_list(const std::vector<std::string_view>& values) {
  std::string text;
  for (const std::string_view value : values) {
    text += fmt::format("{}\"{}\"", text.empty() ? "" : " or ", value);
  }
  return text;
}

// Rows, or those in a file, whose name is relative to the folder.
std::optional<ConfigValue> converted_shape(const ConfigValue* value,
                                           const std::filesystem::path& folder,
                                           std::string& problem) {
  const auto* name = value != nullptr ? std::get_if<std::string>(value) : nullptr;
  const auto* rows = value != nullptr ? std::get_if<std::vector<DarbouxRow>>(value) : nullptr;
  try {
    if (name != nullptr) return ConfigValue(read_shape(folder / *name).rows());
    if (rows != nullptr) return ConfigValue(DarbouxTable(*rows).rows());
    problem = "must be the name of a shape file, or rows [[s, k1, k2, k3], ...]";
  } catch (const InvalidInput& error) {
    problem = error.what();
  }
  return std::nullopt;
}

// The value in the type of the key; otherwise `problem` says what is allowed. Names of files are
// relative to the folder, those of overrides to their own.
std::optional<ConfigValue> converted(const ConfigKey& key, const GivenKey& given,
                                     const std::filesystem::path& folder, std::string& problem) {
  const ConfigValue* value = given.value ? &*given.value : nullptr;
  const auto* word = value != nullptr ? std::get_if<std::string>(value) : nullptr;
  const bool chosen = word != nullptr &&
                      std::find(key.choices.begin(), key.choices.end(), *word) != key.choices.end();
  if (chosen) return *value;
  switch (key.type) {
    case ConfigType::boolean:
      if (value != nullptr && std::holds_alternative<bool>(*value)) return *value;
      problem = "must be true or false";
      return std::nullopt;
    case ConfigType::integer: {
      const auto* v = value != nullptr ? std::get_if<std::int64_t>(value) : nullptr;
      if (v != nullptr && *v >= key.smallest && *v <= key.largest) return *value;
      problem = "must be an integer";
      if (v != nullptr) problem += fmt::format(" from {} to {}", key.smallest, key.largest);
      return std::nullopt;
    }
    case ConfigType::number: {
      double number = NAN;
      if (value != nullptr && std::holds_alternative<double>(*value)) {
        number = std::get<double>(*value);
      } else if (value != nullptr && std::holds_alternative<std::int64_t>(*value)) {
        number = static_cast<double>(std::get<std::int64_t>(*value));
      }
      if (std::isfinite(number)) return ConfigValue(number);
      problem = "must be a finite number";
      if (!key.choices.empty()) problem += " or " + quoted_list(key.choices);
      if (word != nullptr) problem += number_hint(*word);
      if (given.shown == "[...]" && key.section == "wire") {
        problem += ": the wire is the same along its length, sections of it are not read";
      }
      return std::nullopt;
    }
    case ConfigType::choice:
      problem = "must be " + quoted_list(key.choices);
      return std::nullopt;
    case ConfigType::shape:
      return converted_shape(value, given.overrides ? given.folder : folder, problem);
  }
  return std::nullopt;
}

/// Turns given keys into a scenario and gathers what is wrong with them.
class Interpreter {
 public:
  Interpreter(ConfigText text, std::string source)
      : text_(std::move(text)), source_(std::move(source)), problems_(std::move(text_.problems)) {}

  Scenario scenario() {
    check_sections();
    for (const GivenKey& given : text_.keys) accept(given);
    check_rest_shape();
    resolve_wire();
    Scenario result = defaults();
    const bool any_limit = std::any_of(accepted_.begin(), accepted_.end(),
                                       [](const Accepted& a) { return a.key->section == "stop"; });
    if (any_limit) result.stop = StopLimits{};
    for (const Accepted& a : accepted_) a.key->set(result, a.value);
    if (value_of("wire.edge_length") != nullptr && value_of("insertion.increment") == nullptr) {
      result.insertion.increment = result.wire.edge_length / 2;
    }
    check_values(result);
    return result;
  }

  const std::vector<std::string>& problems() const { return problems_; }
  const DeclaredUnits& units() const { return units_; }

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

  bool is_section(std::string_view name) const {
    return std::any_of(keys_.begin(), keys_.end(),
                       [&](const ConfigKey& k) { return k.section == name; });
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

  void check_sections() {
    std::vector<std::string> names;
    for (const ConfigKey& key : keys_) {
      if (names.empty() || names.back() != key.section) names.emplace_back(key.section);
    }
    for (const GivenSection& section : text_.sections) {
      if (is_section(section.name)) continue;
      const std::string meant = nearest(section.name, names);
      problems_.push_back(fmt::format("{}: [{}]: unknown section; {}", section.where, section.name,
                                      meant.empty()
                                          ? fmt::format("there are [{}]", fmt::join(names, "], ["))
                                          : fmt::format("did you mean [{}]?", meant)));
    }
  }

  void accept(const GivenKey& given) {
    if (!is_section(given.section)) return;  // one message per section is enough
    const ConfigKey* key = find(given.section, given.name);
    if (key == nullptr) {
      complain(given, suggestion(given));
      return;
    }
    std::string problem;
    if (auto value =
            converted(*key, given, std::filesystem::path(source_).parent_path(), problem)) {
      accepted_.push_back({key, std::move(*value)});
    } else {
      complain(given, problem);
    }
  }

  // A wire has one shape at rest.
  void check_rest_shape() {
    for (const GivenKey& given : text_.keys) {
      const std::string path = given.section + "." + given.name;
      const bool shaped = value_of("wire.reference_shape") != nullptr;
      if (path == "wire.precurvature" && shaped) {
        complain(given, "wire.reference_shape is given, too; must be only one of them");
      }
      if (path == "wire.reference_shape_beyond" && !shaped) {
        complain(given, "is for wire.reference_shape, which is not given");
      }
    }
  }

  bool is_given(std::string_view path) const {
    return std::any_of(text_.keys.begin(), text_.keys.end(), [&](const GivenKey& given) {
      return given.section + "." + given.name == path;
    });
  }

  void complain_about(std::string_view path, const std::string& problem) {
    for (const GivenKey& given : text_.keys) {
      if (given.section + "." + given.name == path) complain(given, problem);
    }
  }

  std::string word_of(std::string_view path) const {
    const ConfigValue* value = value_of(path);
    return value == nullptr ? std::string() : std::get<std::string>(*value);
  }

  void accept_as(std::string_view section, std::string_view name, const ConfigValue& value) {
    accepted_.push_back({find(section, name), value});
  }

  // Puts the keys in place that others stand for.
  void resolve_wire() {
    GivenNumbers numbers;
    for (const Accepted& a : accepted_) {
      if (const auto* v = std::get_if<double>(&a.value)) numbers.emplace(a.key->path(), *v);
    }
    DeclaredUnits units{word_of("units.length"), word_of("units.force")};
    if (is_given("units.length") != is_given("units.force")) {
      complain_about(units.force.empty() ? "units.length" : "units.force",
                     "length and force are declared together; the other one is missing");
      return;
    }
    for (const KeyProblem& p : resolve_stiffness(numbers, units)) complain_about(p.path, p.problem);
    for (const char* name : {"radius", "youngs_modulus", "poisson_ratio", "stretch_multiplier"}) {
      const auto number = numbers.find(std::string("wire.") + name);
      if (number != numbers.end() && value_of(number->first) == nullptr) {
        accept_as("wire", name, number->second);
      }
    }
    units_ = units;
  }

  std::string suggestion(const GivenKey& given) const {
    std::vector<std::string> names;
    for (const ConfigKey& key : keys_) {
      if (key.section == given.section) names.emplace_back(key.name);
      // a section within this one, such as coil of wire.coil
      const std::string within = given.section + ".";
      if (key.section.starts_with(within)) {
        const std::string inner(key.section.substr(within.size()));
        if (names.empty() || names.back() != inner) names.push_back(inner);
      }
    }
    if (is_section(given.section + "." + given.name)) {
      return fmt::format("is a section; its keys go below [{}.{}]", given.section, given.name);
    }
    const std::string meant = nearest(given.name, names);
    if (!meant.empty()) {
      return fmt::format("unknown key; did you mean {}.{}?", given.section, meant);
    }
    for (const ConfigKey& key : keys_) {
      if (key.name == given.name) {
        return fmt::format("unknown key; did you mean {}?", key.path());
      }
    }
    return fmt::format("unknown key; [{}] has {}", given.section, fmt::join(names, ", "));
  }

  void complain(const GivenKey& given, const std::string& problem) {
    problems_.push_back(fmt::format("{}: {}.{} = {}: {}", given.where, given.section, given.name,
                                    given.shown, problem));
  }

  Scenario defaults() const {
    const Scenario plain;
    Scenario chosen;
    for (const char* name : {"setup", "method"}) {
      const ConfigKey* key = find("packing", name);
      if (const ConfigValue* value = value_of(key->path())) key->set(chosen, *value);
    }
    return default_scenario(chosen.setup, Cavity{number_or("cavity.radius", plain.cavity.radius)},
                            number_or("wire.radius", plain.wire.radius),
                            number_or("wire.youngs_modulus", plain.wire.youngs_modulus),
                            chosen.method);
  }

  void check_values(const Scenario& scenario) {
    std::vector<std::string> of_defaults;
    for (const std::string& problem : wirepack::problems(scenario)) {
      const std::string_view path = std::string_view(problem).substr(0, problem.find(" = "));
      const auto given = std::find_if(text_.keys.begin(), text_.keys.end(), [&](const GivenKey& k) {
        return k.section + "." + k.name == path;
      });
      if (given != text_.keys.end() && value_of(path) != nullptr) {
        problems_.push_back(given->where + ": " + problem);
      } else {
        of_defaults.push_back(source_ + ": " + problem + " (the default; give this key)");
      }
    }
    // A default that follows from a wrong value is not a problem of its own.
    if (problems_.empty()) problems_ = of_defaults;
  }

  const std::vector<ConfigKey> keys_ = config_keys();
  ConfigText text_;
  std::string source_;
  std::vector<std::string> problems_;
  std::vector<Accepted> accepted_;
  DeclaredUnits units_;
};

}  // namespace

Scenario parse_config(std::string_view text, const std::string& source,
                      const std::vector<ConfigOverride>& overrides) {
  ConfigText given = read_config_text(text, source, overrides);
  // What cannot be read has no keys whose values could be wrong.
  const bool readable = !given.keys.empty();
  Interpreter interpreter(std::move(given), source);
  Scenario scenario;
  if (readable) scenario = interpreter.scenario();
  const std::vector<std::string>& found = interpreter.problems();
  if (found.empty()) return scenario;
  const auto shown_end =
      found.begin() + static_cast<std::ptrdiff_t>(std::min(found.size(), most_problems));
  std::string message = fmt::format("{}", fmt::join(found.begin(), shown_end, "\n"));
  if (found.size() > most_problems) {
    message += fmt::format("\nand {} more problems", found.size() - most_problems);
  }
  throw InvalidInput(message);
}

Scenario read_config(const std::filesystem::path& file,
                     const std::vector<ConfigOverride>& overrides) {
  return parse_config(read_text(file, "a configuration", largest_file), file.string(), overrides);
}

DeclaredUnits declared_units(const std::filesystem::path& file,
                             const std::vector<ConfigOverride>& overrides) {
  const std::string text = read_text(file, "a configuration", largest_file);
  Interpreter interpreter(read_config_text(text, file.string(), overrides), file.string());
  interpreter.scenario();
  return interpreter.units();
}

std::vector<std::filesystem::path> config_inputs(const std::filesystem::path& file,
                                                 const std::vector<ConfigOverride>& overrides) {
  std::vector<std::filesystem::path> files{file};
  const std::string text = read_text(file, "a configuration", largest_file);
  for (const GivenKey& key : read_config_text(text, file.string(), overrides).keys) {
    const auto* name = key.value ? std::get_if<std::string>(&*key.value) : nullptr;
    if (name == nullptr || key.section != "wire" || key.name != "reference_shape") continue;
    files.push_back(key.overrides ? std::filesystem::path(*name) : file.parent_path() / *name);
  }
  return files;
}

std::string resolved_config(const Scenario& scenario) {
  std::string text;
  std::string_view section;
  for (const ConfigKey& key : config_keys()) {
    const std::optional<ConfigValue> value = key.get(scenario);
    if (!value) continue;
    if (key.section != section) {
      section = key.section;
      text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", section);
    }
    text += fmt::format("{} = {}\n", key.name, shown(*value));
  }
  return text;
}

namespace {

// How a key differs between two scenarios, or nothing.
std::optional<std::string> difference(const ConfigKey& key, const Scenario& was,
                                      const Scenario& now) {
  const auto text = [](const std::optional<ConfigValue>& value) {
    return value ? shown(*value) : std::string("not set");
  };
  const std::string before = text(key.get(was)), after = text(key.get(now));
  if (before == after) return std::nullopt;
  if (key.type == ConfigType::shape) return key.path() + ": is another one than it was";
  return fmt::format("{}: was {}, is now {}", key.path(), before, after);
}

}  // namespace

std::vector<std::string> given_keys(const std::filesystem::path& file,
                                    const std::vector<ConfigOverride>& overrides) {
  std::vector<std::string> paths;
  const std::string text = read_text(file, "a configuration", largest_file);
  for (const GivenKey& key : read_config_text(text, file.string(), overrides).keys) {
    paths.push_back(key.section + "." + key.name);
  }
  return paths;
}

std::vector<std::string> search_changes(const Scenario& was, const Scenario& now) {
  std::vector<std::string> changes;
  for (const ConfigKey& key : config_keys()) {
    if (key.section != "minimizer" && key.section != "insertion") continue;
    if (const auto change = difference(key, was, now)) changes.push_back(*change);
  }
  return changes;
}

std::optional<std::string> continuation_conflict(const Scenario& was, const Scenario& now,
                                                 const std::vector<std::string>& given) {
  std::vector<std::string> of_user, of_defaults;
  for (const ConfigKey& key : config_keys()) {
    if (key.may_change) continue;
    const auto change = difference(key, was, now);
    if (!change) continue;
    const bool is_given = std::find(given.begin(), given.end(), key.path()) != given.end();
    (is_given ? of_user : of_defaults).push_back(*change);
  }
  of_user.insert(of_user.end(), of_defaults.begin(), of_defaults.end());
  if (of_user.empty()) return std::nullopt;
  return fmt::format("{}", fmt::join(of_user, "\n  "));
}

}  // namespace wirepack
