#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wirepack {

/// Fields of a line, without the blanks and quotes around them: between semicolons where there are
/// any, or else tabs, commas, or blanks. Commas within quotes separate nothing, nor do those within
/// numbers that blanks separate (decimal commas).
struct Fields {
  std::vector<std::string> text;
  bool by_commas = false;
};
Fields fields_of(std::string_view line);

/// A number with a decimal point, or with a decimal comma if that is allowed.
std::optional<double> number_of(std::string text, bool decimal_comma);

/// Unit of the last digit of a number as it is written: 0.01 for "1.25", 0.1 for "2.5e0".
double resolution_of(std::string_view number);

/// Name and unit of a column: "X [mm]" is x in mm. Names are in small letters.
struct ColumnName {
  std::string name, unit;
};
ColumnName column_name(std::string_view field);

}  // namespace wirepack
