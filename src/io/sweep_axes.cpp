#include "sweep_axes.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <sstream>
#include <tuple>

#include "wirepack/core/plain_text.hpp"

namespace wirepack {

namespace {

constexpr double most_values = 1e5;
using Problems = std::vector<std::string>;

auto position(const toml::node& node) {
  return std::pair(node.source().begin.line, node.source().begin.column);
}

std::string as_toml(const toml::node& node) {
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return text.str();
}

// What a value is called in names and tables.
std::string shown_value(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  return as_toml(node);
}

SweepValue value_of(const std::string& key, const toml::node& node, const std::string& source) {
  return {key, as_toml(node), shown_value(node), place(source, node.source())};
}

// Steps of decimal fractions hit them: 0.1, 0.2, 0.3 and not 0.30000000000000004.
double rounded(double number) { return std::stod(fmt::format("{:.12g}", number)); }

/// from, to and step, or count, of a range.
struct Range {
  double from, to, step, count;
  bool whole, ratio;
};

std::optional<double> number_in(const toml::table& table, std::string_view name) {
  const toml::node* node = table.get(name);
  return node != nullptr && node->is_number() ? node->value<double>() : std::nullopt;
}

std::string read_range(const toml::table& table, Range& range) {
  const auto from = number_in(table, "from"), to = number_in(table, "to");
  const auto step = number_in(table, "step"), count = number_in(table, "count");
  for (const auto& [name, node] : table) {
    const bool known = name == "from" || name == "to" || name == "step" || name == "count";
    if (!(known && node.is_number()) && !(name == "spacing" && node.is_string())) {
      return fmt::format("{} is not for a range", name.str());
    }
  }
  if (!from || !to) return "has no from and to";
  if (!std::isfinite(*from) || !std::isfinite(*to)) return "must be finite";
  const std::string spacing = table["spacing"].value_or(std::string("linear"));
  if (spacing != "linear" && spacing != "log") return "spacing must be \"linear\" or \"log\"";
  range = {*from, *to, step.value_or(1), count.value_or(0), true, spacing == "log"};
  for (const auto& [name, node] : table) {
    range.whole = range.whole && (node.is_integer() || name == "count");
  }
  if (step && count) return "has step and count; must be one of them";
  if (range.ratio && !count) return "with spacing \"log\" needs a count";
  if (range.ratio && !(*from > 0 && *to > 0)) return "with spacing \"log\" must be positive";
  if (count) {
    const bool integer = table.get("count")->is_integer();
    return integer && *count >= 2 && *count <= most_values
               ? ""
               : fmt::format("count must be an integer from 2 to {}", most_values);
  }
  range.count = std::floor((*to - *from) / range.step + 1e-9) + 1;
  if (range.count >= 1 && range.count <= most_values) return "";
  return fmt::format("must have 1 to {} values", most_values);
}

std::vector<SweepValue> range_values(const std::string& key, const toml::table& table,
                                     const std::string& source, Problems& problems) {
  Range range{};
  const std::string problem = read_range(table, range);
  if (!problem.empty()) {
    problems.push_back(
        fmt::format("{}: {}: the range {}; a range is {{ from = 1, to = 9, step = 2 }}, "
                    "or with count = 5 in place of the step, and spacing = \"log\"",
                    place(source, table.source()), key, problem));
    return {};
  }
  std::vector<SweepValue> values;
  const bool by_step = !table.contains("count");
  for (double k = 0; k < range.count; ++k) {
    const double part = k / (range.count - 1);
    const double number = by_step       ? range.from + k * range.step
                          : range.ratio ? range.from * std::pow(range.to / range.from, part)
                                        : range.from + (range.to - range.from) * part;
    const std::string text =
        by_step && range.whole ? fmt::format("{:.0f}", number) : fmt::format("{}", rounded(number));
    values.push_back({key, text, text, place(source, table.source())});
  }
  return values;
}

// The values of one key: those of a list or a range.
std::vector<SweepValue> listed_values(const std::string& key, const toml::node& node,
                                      const std::string& source, Problems& problems) {
  if (const toml::table* range = node.as_table()) {
    return range_values(key, *range, source, problems);
  }
  std::vector<SweepValue> values;
  const toml::array* list = node.as_array();
  if (list == nullptr || list->empty()) {
    problems.push_back(fmt::format(
        "{}: sweep.{} = {}: must be a list of values, or a range {{ from = 1, to = 9 }}",
        place(source, node.source()), key, plain_text(as_toml(node), bytes_in_a_message)));
    return values;
  }
  for (const toml::node& value : *list) {
    if (value.is_value()) {
      values.push_back(value_of(key, value, source));
    } else {
      problems.push_back(
          fmt::format("{}: sweep.{}: lists have numbers, strings, true and false; "
                      "other values are for [sweep.cases.NAME]",
                      place(source, value.source()), key));
    }
  }
  return values;
}

/// A key of the configuration with its value, whatever that may be.
struct KeyNode {
  std::string key;
  const toml::node* node;
};

// section.key of all sections, in the order of the text.
std::vector<KeyNode> key_nodes(const toml::table& sections, const std::string& source,
                               Problems& problems) {
  std::vector<KeyNode> found;
  for (const auto& [section, node] : sections) {
    const toml::table* table = node.as_table();
    if (table == nullptr) {
      const std::string name = plain_text(section.str(), bytes_in_a_message);
      problems.push_back(
          fmt::format("{}: {}: must be a section.key of the configuration, such as cavity.radius{}",
                      place(source, node.source()), name,
                      name.find('.') == std::string::npos ? "" : "; write it without quotes"));
      continue;
    }
    for (const auto& [name, value] : *table) {
      found.push_back({fmt::format("{}.{}", section.str(), name.str()), &value});
    }
  }
  std::sort(found.begin(), found.end(), [](const KeyNode& a, const KeyNode& b) {
    return position(*a.node) < position(*b.node);
  });
  return found;
}

SweepAxis zipped(const toml::table& table, const std::string& source, Problems& problems) {
  SweepAxis axis;
  for (const KeyNode& item : key_nodes(table, source, problems)) {
    const std::vector<SweepValue> values = listed_values(item.key, *item.node, source, problems);
    if (axis.keys.empty()) axis.points.resize(values.size());
    axis.keys.push_back(item.key);
    if (values.size() != axis.points.size()) {
      problems.push_back(fmt::format(
          "{}: sweep.zip: {} has {} values, but {} has {}; lists of a zip are equally long",
          place(source, item.node->source()), item.key, values.size(), axis.keys.front(),
          axis.points.size()));
      continue;
    }
    for (std::size_t k = 0; k < values.size(); ++k) axis.points[k].values.push_back(values[k]);
  }
  return axis;
}

SweepAxis cases_of(const toml::table& table, const std::string& source, Problems& problems) {
  SweepAxis axis{{"case"}, {}};
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::string, const toml::table*>> cases;
  for (const auto& [name, node] : table) {
    const std::string shown = plain_text(name.str(), bytes_in_a_message);
    const toml::table* values = node.as_table();
    if (values == nullptr || values->empty()) {
      problems.push_back(
          fmt::format("{}: sweep.cases.{}: must be a table of keys, such as wire.radius = 1",
                      place(source, node.source()), shown));
      continue;
    }
    if (shown.empty()) {
      problems.push_back(
          fmt::format("{}: sweep.cases: a case must have a name", place(source, node.source())));
      continue;
    }
    cases.emplace_back(name.source().begin.line, name.source().begin.column, shown, values);
  }
  std::sort(cases.begin(), cases.end());
  for (const auto& [line, column, name, values] : cases) {
    axis.points.push_back({name, section_values(*values, source, problems)});
  }
  return axis;
}

}  // namespace

std::vector<SweepValue> section_values(const toml::table& sections, const std::string& source,
                                       Problems& problems) {
  std::vector<SweepValue> values;
  for (const KeyNode& item : key_nodes(sections, source, problems)) {
    values.push_back(value_of(item.key, *item.node, source));
  }
  return values;
}

std::vector<SweepAxis> sweep_axes(toml::table& sweep, const std::string& source,
                                  Problems& problems) {
  std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, SweepAxis>> placed;
  if (const toml::node* zips = sweep.get("zip")) {
    const toml::array* list = zips->as_array();
    if (list == nullptr || !list->is_array_of_tables()) {
      problems.push_back(place(source, zips->source()) +
                         ": sweep.zip: must be tables [[sweep.zip]]");
    } else {
      for (const toml::node& zip : *list) {
        placed.emplace_back(position(zip), zipped(*zip.as_table(), source, problems));
      }
    }
    sweep.erase("zip");
  }
  if (const toml::node* cases = sweep.get("cases")) {
    if (const toml::table* table = cases->as_table()) {
      placed.emplace_back(position(*cases), cases_of(*table, source, problems));
    } else {
      problems.push_back(place(source, cases->source()) +
                         ": sweep.cases: must be tables [sweep.cases.NAME]");
    }
    sweep.erase("cases");
  }
  for (const KeyNode& item : key_nodes(sweep, source, problems)) {
    SweepAxis axis{{item.key}, {}};
    for (SweepValue& value : listed_values(item.key, *item.node, source, problems)) {
      axis.points.push_back({"", {std::move(value)}});
    }
    placed.emplace_back(position(*item.node), std::move(axis));
  }
  std::stable_sort(placed.begin(), placed.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<SweepAxis> axes;
  for (auto& [at, axis] : placed) axes.push_back(std::move(axis));
  return axes;
}

}  // namespace wirepack
