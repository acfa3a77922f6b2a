#include "wirepack/packing/history.hpp"

namespace wirepack {

std::vector<HistoryColumn> columns_of(const Scenario& scenario) {
  std::vector<HistoryColumn> columns;
  for (const HistoryColumn& column : history_columns) {
    const bool has =
        column.of == ColumnOf::every_run ||
        (column.of == ColumnOf::friction && scenario.friction.model != FrictionModel::none) ||
        (column.of == ColumnOf::inertia && scenario.method == Method::dynamic);
    if (has) columns.push_back(column);
  }
  return columns;
}

}  // namespace wirepack
