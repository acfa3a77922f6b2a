#include "darboux_rows.hpp"

#include <fmt/format.h>

namespace wirepack {

std::optional<std::vector<DarbouxRow>> darboux_rows(const toml::array& array) {
  std::vector<DarbouxRow> rows;
  for (const toml::node& node : array) {
    const toml::array* row = node.as_array();
    if (row == nullptr || row->size() != 4) return std::nullopt;
    std::array<double, 4> numbers{};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto number = (*row)[i].value<double>();
      if (!(*row)[i].is_number() || !number) return std::nullopt;
      numbers[i] = *number;
    }
    rows.push_back({numbers[0], Vec3(numbers[1], numbers[2], numbers[3])});
  }
  if (rows.empty()) return std::nullopt;
  return rows;
}

std::string text_of(double number) {
  std::string text = fmt::format("{}", number);
  if (text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
  return text;
}

std::string text_of(const std::vector<DarbouxRow>& rows) {
  std::string text = "[";
  for (const DarbouxRow& row : rows) {
    const Vec3& k = row.darboux;
    text += fmt::format("\n  [{}, {}, {}, {}],", text_of(row.arc), text_of(k.x()), text_of(k.y()),
                        text_of(k.z()));
  }
  return text + "\n]";
}

}  // namespace wirepack
