#include "wirepack/io/points_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wirepack/core/error.hpp"

#include "text_file.hpp"

namespace wirepack {

namespace {

constexpr std::size_t largest_file = 200'000'000;
constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Fields between commas or semicolons, or else between blanks.
std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  const std::size_t mark = line.find_first_of(",;");
  if (mark != std::string_view::npos) {
    const char separator = line[mark];
    for (std::size_t begin = 0;;) {
      const std::size_t end = line.find(separator, begin);
      fields.push_back(trimmed(line.substr(begin, end - begin)));
      if (end == std::string_view::npos) return fields;
      begin = end + 1;
    }
  }
  for (std::size_t begin = 0; begin < line.size();) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    if (end > begin) fields.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return fields;
}

std::optional<double> number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string shown(std::string_view text) {
  std::string result;
  for (const char c : text.substr(0, 30)) {
    result += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
  }
  return result;
}

/// What the columns are; indices of x, y, z, arc and sigma, or -1.
struct Columns {
  std::array<int, 5> index{0, 1, 2, -1, -1};
  std::size_t count = 0;
};

constexpr std::array<std::string_view, 5> column_names{"x", "y", "z", "arc", "sigma"};

Columns columns_of_header(const std::vector<std::string_view>& fields, const std::string& where) {
  Columns columns{{-1, -1, -1, -1, -1}, fields.size()};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    std::string name(fields[i]);
    for (char& c : name) {
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    if (name.size() > 1 && name.front() == '"' && name.back() == '"') {
      name = name.substr(1, name.size() - 2);
    }
    if (name == "s" || name == "arc_length") name = "arc";
    const auto known = std::find(column_names.begin(), column_names.end(), name);
    if (known == column_names.end()) {
      throw InvalidInput(fmt::format(
          "{}: column {}: '{}' is no number, and no name of a column either: x, y, z, arc, sigma",
          where, i + 1, shown(fields[i])));
    }
    int& index = columns.index[static_cast<std::size_t>(known - column_names.begin())];
    if (index >= 0) {
      throw InvalidInput(fmt::format("{}: column {}: {} is named twice", where, i + 1, name));
    }
    index = static_cast<int>(i);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    if (columns.index[c] >= 0) continue;
    throw InvalidInput(where + ": the header names no column " + std::string(column_names[c]));
  }
  return columns;
}

Columns columns_of_count(std::size_t count, const std::string& where) {
  if (count < 3 || count > 5) {
    throw InvalidInput(
        fmt::format("{}: has {} column{}; must be x, y, z and, if there are more, arc and sigma",
                    where, count, count == 1 ? "" : "s"));
  }
  return {{0, 1, 2, count > 3 ? 3 : -1, count > 4 ? 4 : -1}, count};
}

}  // namespace

MeasuredPoints read_points(const std::filesystem::path& file) {
  const std::string text = read_text(file, "a list of points", largest_file);
  const std::string name = file.string();
  if (text.find('\0') != std::string::npos) throw InvalidInput(name + ": is not a text file");
  std::optional<Columns> columns;
  std::array<std::vector<double>, 5> values;
  MeasuredPoints points;
  long line_number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = trimmed(std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
    ++line_number;
    if (line_number == 1 && line.substr(0, 3) == "\xEF\xBB\xBF") line = trimmed(line.substr(3));
    if (line.empty() || line.front() == '#') continue;
    const std::string where = fmt::format("{}:{}", name, line_number);
    const std::vector<std::string_view> fields = fields_of(line);
    if (!columns) {
      // A line without any number is a header; one with some numbers is a spoilt first line.
      const bool header =
          std::none_of(fields.begin(), fields.end(), [](auto f) { return number(f).has_value(); });
      columns = header ? columns_of_header(fields, where) : columns_of_count(fields.size(), where);
      if (header) continue;
    }
    if (fields.size() != columns->count) {
      throw InvalidInput(fmt::format("{}: has {} column{} where the lines before have {}", where,
                                     fields.size(), fields.size() == 1 ? "" : "s", columns->count));
    }
    for (std::size_t c = 0; c < 5; ++c) {
      const int index = columns->index[c];
      if (index < 0) continue;
      const std::string_view field = fields[static_cast<std::size_t>(index)];
      const auto value = number(field);
      const auto refuse = [&](const char* allowed) {
        throw InvalidInput(fmt::format("{}: column {} ({}) = {}: {}", where, index + 1,
                                       column_names[c], shown(field), allowed));
      };
      if (!value) refuse("must be a number");
      if (!std::isfinite(*value)) refuse("must be finite");
      if (std::abs(*value) > 1e100) refuse("must be at most 1e100");
      if (c == 4 && !(*value > 0)) refuse("must be positive");
      values[c].push_back(*value);
    }
    points.line.push_back(line_number);
  }
  if (points.line.empty()) throw InvalidInput(name + ": holds no points");
  const auto n = static_cast<Index>(points.line.size());
  const auto column = [&](std::size_t c) {
    return Eigen::Map<const Eigen::VectorXd>(values[c].data(), n);
  };
  points.position.resize(3, n);
  for (Index c = 0; c < 3; ++c) points.position.row(c) = column(static_cast<std::size_t>(c));
  if (columns->index[3] >= 0) points.arc = column(3);
  if (columns->index[4] >= 0) points.sigma = column(4);
  return points;
}

}  // namespace wirepack
