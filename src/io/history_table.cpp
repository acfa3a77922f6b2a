#include "wirepack/io/history_table.hpp"

#include <fmt/format.h>

#include "wirepack/io/round_off.hpp"

namespace wirepack {

HistoryTable::HistoryTable(const Scenario& scenario)
    : radius_(scenario.wire.radius),
      force_unit_(force_unit(scenario)),
      energy_unit_(units_of(scenario).scaled_energy()) {}

std::string HistoryTable::header() const {
  const char* format =
      "#{:>8} {:>10} {:>8} {:>11} {:>11} {:>11} {:>11} {:>6} {:>9} {:>6} {:>8} {:>9}\n";
  return fmt::format(fmt::runtime(format), "incr", "L", "phi", "F", "dE/dL", "E_bend", "E_twist",
                     "snaps", "residual", "evals", "contacts", "overlap") +
         fmt::format(fmt::runtime(format), "", "[a]", "", "[YI/R^2]", "[YI/R^2]", "[YI/R]",
                     "[YI/R]", "", "[YI/R^2]", "", "", "[a]");
}

std::string HistoryTable::line(const HistoryRow& row, const PackingProgress& progress) const {
  const auto part = [&](double energy) {
    return without_round_off(energy, row.energy_total) / energy_unit_;
  };
  return fmt::format(
      "{:9.0f} {:10.4f} {:8.5f} {:11.4e} {:11.4e} {:11.4e} {:11.4e} {:6} {:9.2e} {:6.0f} {:8.0f} "
      "{:9.2e}\n",
      row.increment, row.inserted_length / radius_, row.packing_density, row.scaled_force,
      row.force_difference / force_unit_, part(row.energy_bend), part(row.energy_twist),
      progress.snaps, row.residual, row.evaluations, row.contacts, row.max_overlap / radius_);
}

}  // namespace wirepack
