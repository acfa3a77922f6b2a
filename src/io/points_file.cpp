#include "wirepack/io/points_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "wirepack/core/error.hpp"
#include "wirepack/core/plain_text.hpp"

#include "markups_file.hpp"
#include "text_columns.hpp"
#include "text_file.hpp"

namespace wirepack {

namespace {

constexpr std::size_t largest_file = 200'000'000;
constexpr std::array<std::string_view, 5> meanings{"x", "y", "z", "arc", "sigma"};
using Triple = std::array<std::string_view, 3>;
constexpr std::array<Triple, 6> coordinates{{{"x", "y", "z"},
                                             {"points:0", "points:1", "points:2"},
                                             {"points_0", "points_1", "points_2"},
                                             {"r", "a", "s"},
                                             {"l", "p", "s"},
                                             {"position_x", "position_y", "position_z"}}};
constexpr std::array<std::string_view, 5> arc_names{"arc", "arc_length", "arc length", "s",
                                                    "abscissas"};
constexpr std::array<std::string_view, 3> sigma_names{"sigma", "standard_error", "standard error"};

std::string shown(std::string_view text) { return plain_text(text, 30); }

/// What the columns are: indices of x, y, z, arc and sigma, or -1.
struct Columns {
  std::array<int, 5> index{-1, -1, -1, -1, -1};
  std::size_t count = 0;
  bool named = false;  // by a header
};

std::string list_of(const std::vector<ColumnName>& names) {
  std::string text;
  for (const ColumnName& column : names) {
    text += fmt::format("{}'{}'", text.empty() ? "" : ", ", shown(column.name));
  }
  return text;
}

int place_of(const std::vector<ColumnName>& names, std::string_view name,
             const std::string& where) {
  int found = -1;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].name != name) continue;
    if (found >= 0) {
      throw InvalidInput(fmt::format("{}: column {}: {} is named twice", where, i + 1, name));
    }
    found = static_cast<int>(i);
  }
  return found;
}

// A wrong pair of units would make a wrong shape without a word.
void check_units(const Columns& columns, const std::vector<ColumnName>& names,
                 const std::string& where) {
  std::string unit, of;
  for (std::size_t c = 0; c < meanings.size(); ++c) {
    if (columns.index[c] < 0) continue;
    const ColumnName& name = names[static_cast<std::size_t>(columns.index[c])];
    if (name.unit.empty()) continue;
    if (!unit.empty() && name.unit != unit) {
      throw InvalidInput(fmt::format("{}: {} is in {}, but {} in {}: must be one unit", where, of,
                                     shown(unit), meanings[c], shown(name.unit)));
    }
    unit = name.unit;
    of = meanings[c];
  }
}

Columns columns_by_names(const std::vector<ColumnName>& names, const std::string& where) {
  Columns columns;
  columns.count = names.size();
  columns.named = true;
  for (const Triple& triple : coordinates) {
    std::array<int, 3> place{};
    std::transform(triple.begin(), triple.end(), place.begin(),
                   [&](std::string_view name) { return place_of(names, name, where); });
    if (std::any_of(place.begin(), place.end(), [](int p) { return p < 0; })) continue;
    std::copy(place.begin(), place.end(), columns.index.begin());
    break;
  }
  if (columns.index[0] < 0) {
    std::string missing;
    for (const std::string_view name : coordinates.front()) {
      if (place_of(names, name, where) < 0) missing += fmt::format(" {}", name);
    }
    throw InvalidInput(
        fmt::format("{}: the header names no column{}: it names {}; --columns says which they are",
                    where, missing, list_of(names)));
  }
  const auto first_of = [&](const auto& aliases) {
    for (const std::string_view name : aliases) {
      const int place = place_of(names, name, where);
      if (place >= 0 && place != columns.index[2]) return place;
    }
    return -1;
  };
  columns.index[3] = first_of(arc_names);
  columns.index[4] = first_of(sigma_names);
  return columns;
}

Columns columns_by_count(const Fields& fields, const std::string& where) {
  const std::size_t count = fields.text.size();
  if (count == 6 && fields.by_commas) {
    throw InvalidInput(
        where +
        ": has 6 columns: if these are three numbers with decimal commas, separate "
        "them by semicolons, tabs or blanks; if not, --columns says which are x, y, z");
  }
  if (count < 3 || count > 5) {
    throw InvalidInput(fmt::format(
        "{}: has {} column{}; must be x, y, z and, if there are more, arc and sigma; a header or "
        "--columns says which they are, as in --columns 2,3,4",
        where, count, count == 1 ? "" : "s"));
  }
  return {{0, 1, 2, count > 3 ? 3 : -1, count > 4 ? 4 : -1}, count, false};
}

Columns columns_by_choice(const std::vector<std::string>& chosen,
                          const std::vector<ColumnName>& names, std::size_t count,
                          const std::string& where) {
  Columns columns;
  columns.count = count;
  columns.named = !names.empty();
  if (chosen.size() < 3 || chosen.size() > 5) {
    throw InvalidInput("--columns must be three to five: x, y, z, and arc and sigma if there are");
  }
  for (std::size_t c = 0; c < chosen.size(); ++c) {
    int place = place_of(names, column_name(chosen[c]).name, where);
    const auto number = number_of(chosen[c], false);
    if (place < 0 && number && *number >= 1 && *number <= static_cast<double>(count) &&
        *number == std::floor(*number)) {
      place = static_cast<int>(*number) - 1;
    }
    if (place < 0) {
      throw InvalidInput(
          fmt::format("{}: there is no column '{}' of --columns; {}", where, shown(chosen[c]),
                      names.empty() ? fmt::format("there are {} without names", count)
                                    : "the header names " + list_of(names)));
    }
    if (std::find(columns.index.begin(), columns.index.end(), place) != columns.index.end()) {
      throw InvalidInput(fmt::format("--columns: '{}' is given twice", shown(chosen[c])));
    }
    columns.index[c] = place;
  }
  return columns;
}

/// Takes the lines of a file one after the other.
class Reader {
 public:
  Reader(std::string file, std::vector<std::string> chosen)
      : file_(std::move(file)), chosen_(std::move(chosen)) {}

  void take(std::string_view line, long number) {
    where_ = fmt::format("{}:{}", file_, number);
    Fields fields = fields_of(line);
    if (fields.text.empty()) return;
    const char mark = fields.text.front().empty() ? '\0' : fields.text.front().front();
    if (mark == '#' || mark == '%') return take_comment(line);
    if (started_ && fields.text.size() == columns_.count + 1 && fields.text.back().empty()) {
      fields.text.pop_back();  // a separator behind the last number
    }
    if (!started_ && begins_with_names(fields)) return;
    if (!started_) start(fields);
    if (fields.text.size() != columns_.count) refuse_count(fields);
    for (std::size_t c = 0; c < meanings.size(); ++c) {
      if (columns_.index[c] >= 0) take_value(c, fields.text);
    }
    points_.line.push_back(number);
  }

  MeasuredPoints points() {
    if (points_.line.empty()) {
      throw InvalidInput(names_.empty()
                             ? fmt::format("{}: holds no points", file_)
                             : fmt::format("{}: holds no points: no line is of numbers, the last "
                                           "one begins with '{}'",
                                           file_, names_.front().name));
    }
    const auto n = static_cast<Index>(points_.line.size());
    const auto column = [&](std::size_t c) {
      return Eigen::Map<const Eigen::VectorXd>(values_[c].data(), n);
    };
    points_.position.resize(3, n);
    for (Index c = 0; c < 3; ++c) points_.position.row(c) = column(static_cast<std::size_t>(c));
    if (columns_.index[3] >= 0) points_.arc = column(3);
    if (columns_.index[4] >= 0) points_.sigma = column(4);
    points_.resolution = resolution_;
    return std::move(points_);
  }

 private:
  // A comment may be a header: the last one that names coordinates is.
  void take_comment(std::string_view line) {
    if (started_) return;
    line.remove_prefix(std::min(line.find_first_not_of("#% \t"), line.size()));
    if (const std::size_t mark = line.find("columns = "); mark != std::string_view::npos) {
      line.remove_prefix(mark + 10);
    }
    std::vector<ColumnName> names = names_of(fields_of(line));
    const auto named = [&](std::string_view name) {
      return std::any_of(names.begin(), names.end(),
                         [&](const ColumnName& c) { return c.name == name; });
    };
    for (const Triple& triple : coordinates) {
      if (std::all_of(triple.begin(), triple.end(), named)) comment_names_ = names;
    }
  }

  static std::vector<ColumnName> names_of(const Fields& fields) {
    std::vector<ColumnName> names;
    for (const std::string& field : fields.text) names.push_back(column_name(field));
    return names;
  }

  // A line without any number is a header; one with some numbers is a spoilt first line. Units may
  // have a line of their own.
  bool begins_with_names(const Fields& fields) {
    for (const std::string& field : fields.text) {
      if (number_of(field, true)) return false;
    }
    const std::vector<ColumnName> names = names_of(fields);
    if (names_.size() == names.size()) {
      for (std::size_t i = 0; i < names.size(); ++i) names_[i].unit = names[i].name;
    } else {
      names_ = names;
      header_ = where_;
    }
    return true;
  }

  void start(const Fields& fields) {
    const std::size_t count = fields.text.size();
    if (names_.empty() && comment_names_.size() == count) names_ = comment_names_;
    if (header_.empty()) header_ = where_;
    if (!chosen_.empty()) {
      columns_ =
          columns_by_choice(chosen_, names_, names_.empty() ? count : names_.size(), header_);
    } else if (!names_.empty()) {
      columns_ = columns_by_names(names_, header_);
    } else {
      columns_ = columns_by_count(fields, where_);
    }
    if (!names_.empty()) check_units(columns_, names_, header_);
    started_ = true;
  }

  [[noreturn]] void refuse_count(const Fields& fields) const {
    const std::size_t count = fields.text.size();
    const bool commas = fields.by_commas && count == 2 * columns_.count;
    throw InvalidInput(fmt::format(
        "{}: has {} column{} where {} {}{}", where_, count, count == 1 ? "" : "s",
        columns_.named && points_.line.empty() ? "the header names" : "the lines before have",
        columns_.count,
        commas ? ": decimal commas? Then separate columns by semicolons, tabs or blanks" : ""));
  }

  void take_value(std::size_t c, const std::vector<std::string>& fields) {
    const int index = columns_.index[c];
    const std::string& field = fields[static_cast<std::size_t>(index)];
    const auto value = number_of(field, true);
    const auto refuse = [&](const char* allowed) {
      throw InvalidInput(fmt::format("{}: column {} ({}) = {}: {}", where_, index + 1, meanings[c],
                                     shown(field), allowed));
    };
    if (!value) refuse("must be a number");
    if (!std::isfinite(*value)) refuse("must be finite");
    if (std::abs(*value) > 1e100) refuse("must be at most 1e100");
    if (c == 4 && !(*value > 0)) refuse("must be positive");
    values_[c].push_back(*value);
    if (c < 3) resolution_ = std::min(resolution_, resolution_of(field));
  }

  std::string file_, where_, header_;
  std::vector<std::string> chosen_;
  std::vector<ColumnName> names_, comment_names_;
  Columns columns_;
  bool started_ = false;
  double resolution_ = std::numeric_limits<double>::infinity();
  std::array<std::vector<double>, 5> values_;
  MeasuredPoints points_;
};

}  // namespace

MeasuredPoints read_points(const std::filesystem::path& file,
                           const std::vector<std::string>& columns) {
  const std::string text = read_text(file, "a list of points", largest_file);
  const std::string name = file.string();
  const std::string start = text.substr(0, 2);
  if (start == "\xFF\xFE" || start == "\xFE\xFF") {
    throw InvalidInput(name + ": is UTF-16; must be plain text or UTF-8");
  }
  if (text.find('\0') != std::string::npos) throw InvalidInput(name + ": is not a text file");
  if (file.extension() == ".json") return markups_points(text, name);
  Reader reader(name, columns);
  const char line_end = text.find('\n') == std::string::npos ? '\r' : '\n';
  long line_number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(line_end, begin), text.size());
    std::string_view line = std::string_view(text).substr(begin, end - begin);
    begin = end + 1;
    if (++line_number == 1 && line.substr(0, 3) == "\xEF\xBB\xBF") line.remove_prefix(3);
    reader.take(line, line_number);
  }
  return reader.points();
}

}  // namespace wirepack
