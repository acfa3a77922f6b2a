#include <fmt/format.h>

#include "wirepack/io/export.hpp"

namespace wirepack {

ExportedFiles export_csv(const ExportSource& source) {
  const std::vector<HistoryColumn> columns = columns_of(source.scenario);
  std::string text, units, names;
  for (const std::string& line : source.provenance) text += "# " + line + "\n";
  for (const HistoryColumn& column : columns) {
    const std::string_view separator = names.empty() ? "" : ",";
    units += fmt::format("{}{}", separator, column.unit);
    names += fmt::format("{}{}", separator, column.name);
  }
  text += "# units: " + units + "\n" + names + "\n";
  for (const HistoryRow& row : source.history) {
    std::string line;
    for (const HistoryColumn& column : columns) {
      line += fmt::format("{}{}", line.empty() ? "" : ",", row.*column.value);
    }
    text += line + "\n";
  }
  return {{source.target, text}};
}

}  // namespace wirepack
