#include "config_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <toml++/toml.h>
#include <tuple>

#include "darboux_rows.hpp"
#include "number_hint.hpp"

namespace wirepack {

namespace {

// Names joined by a hundred thousand dots are tables so deep that destroying them overflows the
// stack; no sensible line is that long.
constexpr std::size_t longest_line = 4096;

std::string place(const std::string& source, const toml::source_region& region) {
  return fmt::format("{}:{}:{}", source, region.begin.line, region.begin.column);
}

std::optional<ConfigValue> rows_of(const toml::array& array) {
  if (auto rows = darboux_rows(array)) return ConfigValue(std::move(*rows));
  return std::nullopt;
}

std::optional<ConfigValue> value_of(const toml::node& node) {
  if (const auto* v = node.as_boolean()) return ConfigValue(v->get());
  if (const auto* v = node.as_integer()) return ConfigValue(v->get());
  if (const auto* v = node.as_floating_point()) return ConfigValue(v->get());
  if (const auto* v = node.as_string()) return ConfigValue(v->get());
  if (const auto* v = node.as_array()) return rows_of(*v);
  return std::nullopt;
}

std::string shown_node(const toml::node& node) {
  if (node.is_table()) return "{...}";
  if (node.is_array()) return "[...]";
  if (const auto value = value_of(node)) return shown(*value);
  return "a date or time";
}

// Number of the first line that is too long, or 0.
std::size_t overlong_line(std::string_view text) {
  std::size_t number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end - begin > longest_line) return number;
    begin = end + 1;
  }
  return 0;
}

struct Placed {
  GivenKey key;
  std::uint32_t line, column;
};

bool is_section(const std::string& name) {
  const std::vector<ConfigKey> keys = config_keys();
  return std::any_of(keys.begin(), keys.end(),
                     [&](const ConfigKey& key) { return key.section == name; });
}

// Keys of a section, and of sections within it, such as [wire.coil].
void collect_keys(const toml::table& table, const std::string& section, const std::string& source,
                  std::vector<Placed>& found) {
  for (const auto& [name, value] : table) {
    const std::string inner = section + "." + printable(name.str());
    if (const toml::table* nested = value.as_table(); nested != nullptr && is_section(inner)) {
      collect_keys(*nested, inner, source, found);
      continue;
    }
    const toml::source_region& region = name.source();
    found.push_back({GivenKey{section, printable(name.str()), value_of(value), shown_node(value),
                              place(source, region)},
                     region.begin.line, region.begin.column});
  }
}

void collect(const toml::table& root, const std::string& source, ConfigText& result) {
  std::vector<Placed> found;
  std::vector<std::tuple<std::uint32_t, std::uint32_t, GivenSection>> sections;
  for (const auto& [section, node] : root) {
    const std::string section_name = printable(section.str());
    const toml::source_position at = section.source().begin;
    const toml::table* table = node.as_table();
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
    const toml::table table = toml::parse("value = " + text);
    const toml::node* value = table.get("value");
    if (table.size() == 1 && value != nullptr) {
      key.value = value_of(*value);
      key.shown = shown_node(*value);
      return key;
    }
  } catch (const toml::parse_error&) {  // NOLINT(bugprone-empty-catch): it is a bare string
  }
  key.value = ConfigValue(text);
  key.shown = shown(*key.value);
  return key;
}

std::string trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return std::string(text.substr(begin, text.find_last_not_of(" \t") + 1 - begin));
}

void apply(const ConfigOverride& change, ConfigText& result) {
  const std::string origin = printable(change.origin, 120);
  const auto at = std::min(change.assignment.find('='), change.assignment.size());
  const std::string path = trimmed(change.assignment.substr(0, at));
  const std::string value =
      trimmed(change.assignment.substr(std::min(at + 1, change.assignment.size())));
  const auto dot = path.rfind('.');
  const bool complete = dot != std::string::npos && dot > 0 && dot + 1 < path.size() &&
                        !value.empty() && change.assignment.size() <= longest_line;
  if (!complete) {
    result.problems.push_back(
        fmt::format("{}: must have the form section.key=value, such as cavity.radius=10", origin));
    return;
  }
  GivenKey key = parse_override_value(value);
  key.section = printable(path.substr(0, dot));
  key.name = printable(path.substr(dot + 1));
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

// What a line gives where it cannot be read, if that was meant as a number.
std::string line_hint(std::string_view text, std::uint32_t line) {
  for (std::uint32_t i = 1; i < line && !text.empty(); ++i) {
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  }
  text = text.substr(0, text.find_first_of("\r\n#"));
  const auto equals = text.find('=');
  if (equals == std::string_view::npos) return {};
  const std::string value = trimmed(text.substr(equals + 1));
  const std::string hint = number_hint(value);
  if (hint.empty()) return {};
  return fmt::format("{} = {}: is no number{}", printable(trimmed(text.substr(0, equals))),
                     printable(value), hint);
}

}  // namespace

std::string printable(std::string_view text, std::size_t longest) {
  std::string result(text.substr(0, longest));
  // a character of UTF-8 that was cut in two goes as a whole
  if (text.size() > longest) {
    while (!result.empty() && (static_cast<unsigned char>(result.back()) & 0xC0) == 0x80) {
      result.pop_back();
    }
    if (!result.empty() && static_cast<unsigned char>(result.back()) >= 0xC0) result.pop_back();
    result += "...";
  }
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  }
  return result;
}

std::string shown(const ConfigValue& value) {
  if (const bool* v = std::get_if<bool>(&value)) return *v ? "true" : "false";
  if (const auto* v = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *v);
  if (const auto* v = std::get_if<std::string>(&value)) return '"' + printable(*v) + '"';
  if (const auto* v = std::get_if<std::vector<DarbouxRow>>(&value)) return text_of(*v);
  return text_of(std::get<double>(value));
}

std::optional<std::string> unreadable(std::string_view text, const std::string& source) {
  if (text.find('\0') != std::string_view::npos) return source + ": is not a text file";
  if (const std::size_t line = overlong_line(text); line > 0) {
    return fmt::format("{}:{}:1: the line has more than {} characters", source, line, longest_line);
  }
  return std::nullopt;
}

ConfigText read_config_text(std::string_view text, const std::string& source,
                            const std::vector<ConfigOverride>& overrides) {
  ConfigText result;
  if (const auto problem = unreadable(text, source)) {
    result.problems.push_back(*problem);
    return result;
  }
  try {
    collect(toml::parse(text), source, result);
  } catch (const toml::parse_error& error) {
    const std::string hint = line_hint(text, error.source().begin.line);
    result.problems.push_back(
        fmt::format("{}: {}", place(source, error.source()),
                    hint.empty() ? printable(error.description(), 300) : hint));
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
