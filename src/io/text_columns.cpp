#include "text_columns.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "trimmed.hpp"

namespace wirepack {

namespace {

std::string unquoted(std::string_view field) {
  field = trimmed(field);
  const bool quoted = field.size() > 1 && (field.front() == '"' || field.front() == '\'') &&
                      field.back() == field.front();
  return std::string(quoted ? trimmed(field.substr(1, field.size() - 2)) : field);
}

// Parts between separators that are not within quotes. Successive blanks separate once.
std::vector<std::string> split(std::string_view line, std::string_view separators, bool each) {
  std::vector<std::string> parts;
  char quote = 0;
  std::size_t begin = 0;
  const auto add = [&](std::size_t end) {
    if (each || end > begin) parts.push_back(unquoted(line.substr(begin, end - begin)));
    begin = end + 1;
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const bool opens = (c == '"' || c == '\'') && trimmed(line.substr(begin, i - begin)).empty();
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (opens) {
      quote = c;
    } else if (separators.find(c) != std::string_view::npos) {
      add(i);
    }
  }
  add(line.size());
  return parts;
}

bool all_numbers(const std::vector<std::string>& fields, bool decimal_comma) {
  return std::all_of(fields.begin(), fields.end(),
                     [&](const std::string& f) { return number_of(f, decimal_comma).has_value(); });
}

constexpr std::array<std::string_view, 17> units{
    "km", "m",  "dm",   "cm", "mm",    "um", "\xC2\xB5m", "\xCE\xBCm", "nm",
    "pm", "in", "inch", "ft", "pixel", "px", "voxel",     "angstrom"};

bool is_unit(std::string_view text) {
  return std::find(units.begin(), units.end(), text) != units.end();
}

}  // namespace

Fields fields_of(std::string_view line) {
  const std::vector<std::string> by_blanks = split(line, blanks, false);
  if (auto parts = split(line, ";", true); parts.size() > 1) return {std::move(parts), false};
  if (by_blanks.size() > 1 && all_numbers(by_blanks, true)) return {by_blanks, false};
  if (auto parts = split(line, "\t", true); parts.size() > 1) return {std::move(parts), false};
  if (auto parts = split(line, ",", true); parts.size() > 1) return {std::move(parts), true};
  return {by_blanks, false};
}

std::optional<double> number_of(std::string text, bool decimal_comma) {
  const std::size_t comma = text.find(',');
  if (decimal_comma && comma != std::string::npos && text.find('.') == std::string::npos) {
    text[comma] = '.';
  }
  const char* begin = text.data();
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') ++begin;
  double value = 0;
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (end != text.data() + text.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    const std::size_t exponent = text.find_first_of("eE");
    const bool tiny =
        exponent != std::string::npos && text.find('-', exponent) != std::string::npos;
    return tiny ? 0.0 : HUGE_VAL;
  }
  if (error != std::errc()) return std::nullopt;
  return value;
}

double resolution_of(std::string_view number) {
  const std::size_t exponent = number.find_first_of("eE");
  const std::string_view digits = number.substr(0, exponent);
  const std::size_t mark = digits.find_first_of(".,");
  int power = 0;
  if (exponent != std::string_view::npos) {
    const std::size_t begin = exponent + (number.substr(exponent + 1, 1) == "+" ? 2 : 1);
    std::from_chars(number.data() + begin, number.data() + number.size(), power);
  }
  if (mark != std::string_view::npos) power -= static_cast<int>(digits.size() - mark - 1);
  return std::pow(10.0, power);
}

ColumnName column_name(std::string_view field) {
  ColumnName result;
  for (const char c : trimmed(field)) {
    result.name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  std::string& name = result.name;
  const std::size_t open = name.find_first_of("[(");
  if (open != std::string::npos && open > 0 && (name.back() == ']' || name.back() == ')')) {
    result.unit = trimmed(std::string_view(name).substr(open + 1, name.size() - open - 2));
    name = trimmed(std::string_view(name).substr(0, open));
    return result;
  }
  const std::size_t mark = name.find_last_of("_/ ");
  if (mark != std::string::npos && mark > 0 && is_unit(std::string_view(name).substr(mark + 1))) {
    result.unit = name.substr(mark + 1);
    name = trimmed(std::string_view(name).substr(0, mark));
  }
  return result;
}

}  // namespace wirepack
