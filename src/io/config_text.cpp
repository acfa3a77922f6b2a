#include "config_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <tuple>

#include "wirepack/core/error.hpp"
#include "wirepack/core/plain_text.hpp"

#include "darboux_rows.hpp"
#include "toml_text.hpp"
#include "trimmed.hpp"

namespace wirepack {

namespace {

std::string shown_name(std::string_view name) { return plain_text(name, bytes_in_a_message); }

std::optional<ConfigValue> vector_or_rows(const toml::array& array) {
  const auto number = [&](std::size_t k) { return array[k].value<double>(); };
  if (array.size() == 3 && number(0) && number(1) && number(2)) {
    return ConfigValue(Vec3(*number(0), *number(1), *number(2)));
  }
  if (auto rows = darboux_rows(array)) return ConfigValue(std::move(*rows));
  return std::nullopt;
}

std::optional<ConfigValue> value_of(const toml::node& node) {
  if (const auto* v = node.as_boolean()) return ConfigValue(v->get());
  if (const auto* v = node.as_integer()) return ConfigValue(v->get());
  if (const auto* v = node.as_floating_point()) return ConfigValue(v->get());
  if (const auto* v = node.as_string()) return ConfigValue(v->get());
  if (const auto* v = node.as_array()) return vector_or_rows(*v);
  return std::nullopt;
}

std::string shown_node(const toml::node& node) {
  if (node.is_table()) return "{...}";
  if (node.is_array()) return "[...]";
  if (const auto value = value_of(node)) return shown(*value);
  return "a date or time";
}

struct Placed {
  GivenKey key;
  std::uint32_t line, column;
};

// Keys of a section, and of sections within it, such as [wire.coil].
void collect_keys(const toml::table& table, const std::string& section, const std::string& source,
                  std::vector<Placed>& found) {
  for (const auto& [name, value] : table) {
    const std::string inner = section + "." + shown_name(name.str());
    if (const toml::table* nested = value.as_table();
        nested != nullptr && is_section(inner, config_keys())) {
      collect_keys(*nested, inner, source, found);
      continue;
    }
    const toml::source_region& region = name.source();
    found.push_back({GivenKey{section, shown_name(name.str()), value_of(value), shown_node(value),
                              place(source, region)},
                     region.begin.line, region.begin.column});
  }
}

void collect(const toml::table& root, const std::string& source, ConfigText& result) {
  if (root["shape"]["model"] && !root.contains("cavity")) {
    throw InvalidInput(source +
                       ": is the shape of a wire, for wire.reference_shape; a configuration "
                       "has sections such as [cavity]");
  }
  std::vector<Placed> found;
  std::vector<std::tuple<std::uint32_t, std::uint32_t, GivenSection>> sections;
  for (const auto& [section, node] : root) {
    const std::string section_name = shown_name(section.str());
    const toml::source_position at = section.source().begin;
    const toml::table* table = node.as_table();
    if (node.is_array_of_tables() && is_section(section_name, config_keys())) {
      const char* const one =
          section_name == "wire" ? "several wires are not possible" : "there is one of them";
      result.problems.push_back(fmt::format("{}: [[{}]]: {}; write [{}]",
                                            place(source, section.source()), section_name, one,
                                            section_name));
      continue;
    }
    if (table == nullptr) {
      result.problems.push_back(
          fmt::format("{}: {} = {}: is outside of a section; every key belongs to one, such as "
                      "radius to [cavity]",
                      place(source, section.source()), section_name, shown_node(node)));
      continue;
    }
    sections.emplace_back(at.line, at.column,
                          GivenSection{section_name, place(source, section.source())});
    collect_keys(*table, section_name, source, found);
  }
  // tables are sorted by name; messages go along the text
  std::sort(found.begin(), found.end(), [](const Placed& a, const Placed& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  });
  std::sort(sections.begin(), sections.end(), [](const auto& a, const auto& b) {
    return std::tie(std::get<0>(a), std::get<1>(a)) < std::tie(std::get<0>(b), std::get<1>(b));
  });
  for (Placed& p : found) result.keys.push_back(std::move(p.key));
  for (auto& s : sections) result.sections.push_back(std::move(std::get<2>(s)));
}

// The value as TOML, or the bare text where it is none: `--set packing.setup=high_torsion`.
GivenKey parse_override_value(const std::string& text) {
  GivenKey key;
  try {
    const toml::table table = toml_table("value = " + text, "");
    const toml::node* value = table.get("value");
    if (table.size() == 1 && value != nullptr) {
      key.value = value_of(*value);
      key.shown = shown_node(*value);
      return key;
    }
  } catch (const InvalidInput&) {  // NOLINT(bugprone-empty-catch): it is a bare string
  }
  key.value = ConfigValue(text);
  key.shown = shown(*key.value);
  return key;
}

void apply(const ConfigOverride& change, ConfigText& result) {
  const std::string origin = plain_text(change.origin, 120);
  const auto at = std::min(change.assignment.find('='), change.assignment.size());
  const std::string_view assignment = change.assignment;
  const std::string_view path = trimmed(assignment.substr(0, at));
  const std::string_view value = trimmed(assignment.substr(std::min(at + 1, assignment.size())));
  const auto dot = path.rfind('.');
  const bool complete =
      dot != std::string::npos && dot > 0 && dot + 1 < path.size() && !value.empty();
  if (!complete) {
    result.problems.push_back(
        fmt::format("{}: must have the form section.key=value, such as cavity.radius=10", origin));
    return;
  }
  GivenKey key = parse_override_value(std::string(value));
  key.section = shown_name(path.substr(0, dot));
  key.name = shown_name(path.substr(dot + 1));
  key.where = origin;
  key.overrides = true;
  key.folder = change.folder;
  const auto same = [&](const GivenKey& k) {
    return k.section == key.section && k.name == key.name;
  };
  std::erase_if(result.keys, same);
  const bool known = std::any_of(result.sections.begin(), result.sections.end(),
                                 [&](const GivenSection& s) { return s.name == key.section; });
  if (!known) result.sections.push_back({key.section, origin});
  result.keys.push_back(std::move(key));
}

}  // namespace

std::string shown(const ConfigValue& value) {
  if (const bool* v = std::get_if<bool>(&value)) return *v ? "true" : "false";
  if (const auto* v = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *v);
  if (const auto* v = std::get_if<std::string>(&value))
    return '"' + plain_text(*v, bytes_in_a_message) + '"';
  if (const auto* v = std::get_if<std::vector<DarbouxRow>>(&value)) return text_of(*v);
  if (const auto* v = std::get_if<Vec3>(&value)) {
    return fmt::format("[{}, {}, {}]", text_of(v->x()), text_of(v->y()), text_of(v->z()));
  }
  return text_of(std::get<double>(value));
}

ConfigText read_config_text(std::string_view text, const std::string& source,
                            const std::vector<ConfigOverride>& overrides) {
  ConfigText result;
  try {
    collect(toml_table(text, source), source, result);
  } catch (const InvalidInput& error) {
    result.problems.emplace_back(error.what());
    return result;
  }
  for (const ConfigOverride& change : overrides) apply(change, result);
  if (result.keys.empty() && result.problems.empty()) {
    result.problems.push_back(source +
                              ": has no key at all; give at least `radius = 10` in [cavity]");
  }
  return result;
}

}  // namespace wirepack
