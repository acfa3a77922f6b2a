#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// One row per increment: everything the history of a run holds. Units are those of the
/// configuration unless the name says scaled.
struct HistoryRow {
  double increment = 0;         ///< 1, 2, ...
  double inserted_length = 0;   ///< L, from the clamp
  double packing_density = 0;   ///< 3 a^2 L / (4 R^3)
  double force = 0;             ///< explicit dE/dL at the minimum
  double force_difference = 0;  ///< difference of minimal energies over the increment
  double scaled_force = 0;      ///< F R^2 / YI
  double energy_total = 0;
  double energy_stretch = 0;
  double energy_bend = 0;
  double energy_twist = 0;
  double energy_wall = 0;
  double energy_contact = 0;
  double snap_energy = 0;  ///< released by a snap within this increment
  double residual = 0;     ///< largest gradient component over YI / R^2
  double stable = 1;       ///< 1: a minimum; 0: a saddle without escape
  double evaluations = 0;
  double contacts = 0;
  double max_overlap = 0;
  double wall_seconds = 0;  ///< since the start; the only column that differs between equal runs
  // Of runs with friction:
  double friction_dissipation = 0;  ///< within this increment
  // Of runs with inertia:
  double time = 0;
  double energy_kinetic = 0;
  double viscous_dissipation = 0;  ///< within this increment
  double work = 0;                 ///< of the insertion within this increment
  double audit_residual = 0;       ///< part of all work so far that has gone nowhere
};

/// Which runs have a column.
enum class ColumnOf { every_run, friction, inertia };

/// Name, unit and place of a column. Units are powers of the base units of the configuration.
struct HistoryColumn {
  std::string_view name, unit;
  double HistoryRow::*value;
  bool integer = false;
  ColumnOf of = ColumnOf::every_run;
  bool added_later = false;  ///< files of earlier formats may lack it
};

inline constexpr std::array<HistoryColumn, 25> history_columns{{
    {"increment", "1", &HistoryRow::increment, true},
    {"inserted_length", "length", &HistoryRow::inserted_length},
    {"packing_density", "1", &HistoryRow::packing_density},
    {"force", "force", &HistoryRow::force},
    {"force_difference", "force", &HistoryRow::force_difference},
    {"scaled_force", "YI/R^2", &HistoryRow::scaled_force},
    {"energy_total", "force length", &HistoryRow::energy_total},
    {"energy_stretch", "force length", &HistoryRow::energy_stretch},
    {"energy_bend", "force length", &HistoryRow::energy_bend},
    {"energy_twist", "force length", &HistoryRow::energy_twist},
    {"energy_wall", "force length", &HistoryRow::energy_wall},
    {"energy_contact", "force length", &HistoryRow::energy_contact},
    {"snap_energy", "force length", &HistoryRow::snap_energy},
    {"residual", "YI/R^2", &HistoryRow::residual},
    {"stable", "1", &HistoryRow::stable, true, ColumnOf::every_run, true},
    {"evaluations", "1", &HistoryRow::evaluations, true},
    {"contacts", "1", &HistoryRow::contacts, true},
    {"max_overlap", "length", &HistoryRow::max_overlap},
    {"wall_seconds", "s", &HistoryRow::wall_seconds},
    {"friction_dissipation", "force length", &HistoryRow::friction_dissipation, false,
     ColumnOf::friction},
    {"time", "time", &HistoryRow::time, false, ColumnOf::inertia},
    {"energy_kinetic", "force length", &HistoryRow::energy_kinetic, false, ColumnOf::inertia},
    {"viscous_dissipation", "force length", &HistoryRow::viscous_dissipation, false,
     ColumnOf::inertia},
    {"work", "force length", &HistoryRow::work, false, ColumnOf::inertia},
    {"audit_residual", "1", &HistoryRow::audit_residual, false, ColumnOf::inertia},
}};

/// The columns that a run of this scenario has.
std::vector<HistoryColumn> columns_of(const Scenario& scenario);

}  // namespace wirepack
