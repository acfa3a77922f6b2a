#include "run_summary.hpp"

#include <fmt/format.h>

#include "wirepack/io/round_off.hpp"
#include "wirepack/packing/own_units.hpp"

namespace wirepack {

namespace {

// A run with inertia is slow enough when on average it has less of its energy in motion.
constexpr double quasistatic_share = 0.02;

std::string line(std::string_view name, const std::string& value) {
  return fmt::format("# {:<22}{}\n", name, value);
}

std::string extent(const RecordedRun& run, const Scenario& scenario, const DeclaredUnits& names) {
  const HistoryRow& last = run.last;
  return line("stopped by", run.stop ? std::string(name_of(*run.stop)) : "a signal") +
         line("phi_max", fmt::format("{:.6f}", last.packing_density)) +
         line("inserted length",
              fmt::format("{:.6g} a", last.inserted_length / scenario.wire.radius)) +
         line("force",
              fmt::format("{:.6g} YI/R^2 = {}", last.scaled_force, shown_force(last.force, names)));
}

// Where the work has gone.
std::string energies(const RecordedRun& run, const Scenario& scenario, const DeclaredUnits& names) {
  const Units units = units_of(scenario);
  const WorkBalance balance = in_units(run.progress.balance, units);
  const auto energy = [&](std::string_view name, double value) {
    value = without_round_off(value, balance.work);
    return line(name, fmt::format("{:.6g} YI/R = {}", value / units.scaled_energy(),
                                  shown_energy(value, names)));
  };
  std::string text = energy("work int F dL", balance.work);
  text += energy("  stored energy", run.last.energy_total);
  if (scenario.method == Method::dynamic) {
    text += energy("  kinetic energy", run.last.energy_kinetic);
    text += energy("  rubbed off", balance.friction);
    text += energy("  viscous", balance.viscous);
  } else {
    text += energy("  released in snaps", balance.released);
    if (scenario.friction.model != FrictionModel::none) {
      text += energy("  rubbed off", balance.friction);
      text += energy("  held by contacts", balance.contact_springs);
    }
  }
  text += energy("  lost in remeshing", balance.remeshing);
  const double percent = balance.work != 0 ? 100 * residue(balance, run.last) / balance.work : 0;
  return text + line("  residue", fmt::format("{:.3g} % of the work", percent));
}

std::string steps_in_time(const RecordedRun& run) {
  const RunTotals& totals = run.totals;
  const double share = totals.stored > 0 ? totals.kinetic / totals.stored : 0;
  const char* advice =
      share > quasistatic_share ? ": too fast; lower dynamics.insertion_speed" : "";
  return line("kinetic over stored",
              fmt::format("{:.2g} %, mean of the run{}", 100 * share, advice)) +
         line("time steps", fmt::format("{}", run.progress.work.evaluations));
}

std::string counts(const SolverWork& work) {
  std::string text;
  for (const auto& entry : work_counts) {
    text += line(entry.label, fmt::format("{}", work.*entry.value));
  }
  return text;
}

std::string minimizations(const RecordedRun& run, const Scenario& scenario) {
  const PackingProgress& progress = run.progress;
  const SolverWork& work = progress.work;
  return line("snaps", fmt::format("{}", progress.snaps)) +
         line("rollbacks", fmt::format("{}", progress.rollbacks)) + counts(work) +
         line("largest residual",
              fmt::format("{:.3g} YI/R^2 (tolerance {:.3g})", run.totals.largest_residual,
                          scenario.minimizer.tolerance));
}

// What the time was spent on.
std::string shares_of_time(const SolverWork& work, double whole) {
  const auto share = [&](std::string_view name, double seconds) {
    return line(fmt::format("  {}", name),
                fmt::format("{:.2f} s, {:.0f} %", seconds, 100 * seconds / whole));
  };
  std::string text;
  double rest = whole;
  for (const auto& entry : work_seconds) {
    text += share(entry.label, work.*entry.value);
    rest -= work.*entry.value;
  }
  return text + share("all else", rest);
}

}  // namespace

std::string summary(const RecordedRun& run, const Scenario& scenario, const DeclaredUnits& names) {
  const bool in_time = scenario.method == Method::dynamic;
  const RunTotals& totals = run.totals;
  std::string text = "#\n";
  text += extent(run, scenario, names) + energies(run, scenario, names);
  text += in_time ? steps_in_time(run) : minimizations(run, scenario);
  text += line("largest overlap",
               fmt::format("{:.3g} a", totals.largest_overlap / scenario.wire.radius));
  text += line("time", fmt::format("{:.1f} s", totals.seconds));
  // with inertia one loop does all
  return in_time ? text : text + shares_of_time(run.progress.work, totals.seconds);
}

}  // namespace wirepack
