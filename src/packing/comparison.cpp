#include "wirepack/packing/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "wirepack/core/error.hpp"
#include "wirepack/observe/coil_report.hpp"
#include "wirepack/observe/packing_density.hpp"
#include "wirepack/observe/spool_model.hpp"
#include "wirepack/observe/strand_spacing.hpp"
#include "wirepack/packing/imperfection.hpp"

namespace wirepack {

namespace {

// Lengths are sums of increments, in any unit: rows at the end of a range must not depend on that.
constexpr double round_off = 1e-9;

using Value = std::optional<double>;
/// Value of a run near a density.
using Reading = std::function<Value(const ComparedRun&, double density)>;

// Mean of rows within the window.
Reading mean_of_rows(double window, std::function<double(const Scenario&, const HistoryRow&)> of) {
  return [=](const ComparedRun& run, double density) -> Value {
    double sum = 0;
    int count = 0;
    for (const HistoryRow& row : run.history) {
      if (std::abs(row.packing_density - density) > window * (1 + round_off)) continue;
      sum += of(run.scenario, row);
      ++count;
    }
    return count > 0 ? Value(sum / count) : std::nullopt;
  };
}

// Of the frame nearest to the density, if one lies within the window.
Reading of_frame(double window, std::function<Value(const Scenario&, const PackingFrame&)> of) {
  return [=](const ComparedRun& run, double density) -> Value {
    const auto off = [&](const PackingFrame& f) { return std::abs(f.packing_density - density); };
    const auto nearest =
        std::min_element(run.frames.begin(), run.frames.end(),
                         [&](const auto& a, const auto& b) { return off(a) < off(b); });
    if (nearest == run.frames.end() || off(*nearest) > window) return std::nullopt;
    return of(run.scenario, *nearest);
  };
}

Value spacing_of(const Scenario& scenario, const PackingFrame& frame) {
  const StrandSpacing spacing = strand_spacing(frame.rod);
  if (spacing.pairs < 10) return std::nullopt;  // too few to be a mean
  return spacing.mean / scenario.wire.radius;
}

Value axis_order(const Scenario& scenario, const PackingFrame& frame) {
  RodState rod = frame.rod;
  rod.twist_guide.assign(static_cast<std::size_t>(rod.node_count()), 0.0);
  const double order = coil_report(rod, drawn_setup(scenario).nozzle.direction).axis_order;
  return order != 0 ? Value(order) : std::nullopt;  // 0: not a turn yet
}

SeedMean mean_over_seeds(const std::vector<double>& values) {
  SeedMean result;
  result.seeds = static_cast<int>(values.size());
  for (const double v : values) result.mean += v / result.seeds;
  if (result.seeds < 2) return result;
  double square = 0;
  for (const double v : values) square += (v - result.mean) * (v - result.mean);
  result.error = std::sqrt(square / (result.seeds - 1) / result.seeds);
  return result;
}

template <class F>
void for_each_run(const std::vector<ComparedRun>& runs, Way way, F&& f) {
  for (const ComparedRun& run : runs) {
    if (run.way == way) f(run);
  }
}

ComparedQuantity quantity(const std::vector<ComparedRun>& runs,
                          const std::vector<double>& densities, std::string name, std::string unit,
                          double tolerance, bool relative, const Reading& reading) {
  ComparedQuantity q{std::move(name), std::move(unit), tolerance, relative, {}, {}};
  for (std::size_t w = 0; w < ways.size(); ++w) {
    for (const double density : densities) {
      std::vector<double> values;
      for_each_run(runs, ways[w].first, [&](const ComparedRun& run) {
        if (const Value v = reading(run, density)) values.push_back(*v);
      });
      q.values[w].push_back(values.empty() ? std::nullopt : std::optional(mean_over_seeds(values)));
    }
  }
  return q;
}

void add_spool(ComparedQuantity& q, const std::vector<double>& densities, const SpoolModel& spool,
               double (SpoolModel::*of)(double) const, double unit) {
  for (const double phi : densities) {
    q.spool.push_back(phi < spool.largest_density() ? Value((spool.*of)(phi) / unit)
                                                    : std::nullopt);
  }
}

bool rubs(Way way) { return way == Way::quasistatic_friction || way == Way::dynamic_friction; }

// Rows from the length of 4 R, by which the wire has curled up, to the end of the common range.
template <class F>
void for_each_curled_row(const ComparedRun& run, double largest, F&& f) {
  const double curled = 4 * run.scenario.cavity.radius;
  const HistoryRow* before = nullptr;
  for (const HistoryRow& row : run.history) {
    if (row.packing_density > largest * (1 + round_off)) break;
    if (row.inserted_length > curled * (1 + round_off) && before != nullptr) f(*before, row);
    before = &row;
  }
}

ForceBudget budget_of(const std::vector<ComparedRun>& runs, Way way, double largest) {
  ForceBudget sum{way};
  int count = 0;
  for_each_run(runs, way, [&](const ComparedRun& run) {
    ForceBudget one{way};
    double length = 0;
    for_each_curled_row(run, largest, [&](const HistoryRow& before, const HistoryRow& row) {
      const double fed = row.inserted_length - before.inserted_length;
      length += fed;
      one.force += row.force * fed;
      one.stored +=
          row.energy_total + row.energy_kinetic - before.energy_total - before.energy_kinetic;
      one.released += row.snap_energy;
      one.friction += row.friction_dissipation;
      one.viscous += row.viscous_dissipation;
    });
    const double unit = length * units_of(run.scenario).scaled_force();
    if (!(length > 0)) return;
    ++count;
    sum.force += one.force / unit;
    sum.stored += one.stored / unit;
    sum.released += one.released / unit;
    sum.friction += one.friction / unit;
    sum.viscous += one.viscous / unit;
  });
  if (count > 0) {
    for (double* v : {&sum.force, &sum.stored, &sum.released, &sum.friction, &sum.viscous})
      *v /= count;
  }
  return sum;
}

Cost cost_of(const std::vector<ComparedRun>& runs, Way way, double largest) {
  Cost sum{way};
  int count = 0;
  for_each_run(runs, way, [&](const ComparedRun& run) {
    ++count;
    double seconds = 0;
    for (const HistoryRow& row : run.history) {
      if (row.packing_density > largest * (1 + round_off)) break;
      sum.evaluations += row.evaluations;
      seconds = row.wall_seconds;
    }
    sum.seconds += seconds;
  });
  if (count > 0) {
    sum.evaluations /= count;
    sum.seconds /= count;
  }
  return sum;
}

}  // namespace

Scenario scenario_of(Way way, Scenario scenario) {
  const bool moves = way == Way::dynamic || way == Way::dynamic_friction;
  scenario.method = moves ? Method::dynamic : Method::quasistatic;
  scenario.friction.model = rubs(way) ? FrictionModel::coulomb : FrictionModel::none;
  return scenario;
}

std::vector<std::optional<double>> ComparedQuantity::differences() const {
  std::vector<std::optional<double>> result;
  const auto& reference = values[static_cast<std::size_t>(Way::quasistatic)];
  const auto& other = values[static_cast<std::size_t>(Way::dynamic)];
  for (std::size_t i = 0; i < reference.size(); ++i) {
    if (!reference[i] || !other[i]) {
      result.emplace_back(std::nullopt);
      continue;
    }
    const double difference = other[i]->mean - reference[i]->mean;
    result.emplace_back(relative ? difference / std::abs(reference[i]->mean) : difference);
  }
  return result;
}

std::optional<double> ComparedQuantity::mean_difference() const {
  double sum = 0;
  int count = 0;
  for (const auto& d : differences()) {
    if (!d || !std::isfinite(*d)) continue;
    sum += *d;
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

namespace {

// Four increments of the default, which lie evenly about the sawtooth of a growing inlet edge.
double averaging_window(const Scenario& scenario) {
  const double sawtooth =
      packing_density(2 * scenario.wire.edge_length, scenario.cavity, scenario.wire.radius);
  return std::max(sawtooth, 0.008);
}

}  // namespace

std::vector<double> compared_densities(const Scenario& scenario, double largest) {
  const double curled =
      packing_density(4 * scenario.cavity.radius, scenario.cavity, scenario.wire.radius);
  std::vector<double> densities;
  for (int k = 1; k <= 40; ++k) {
    const double phi = 0.025 * k;
    if (phi > 0.1 && k % 2 != 0) continue;
    if (phi - averaging_window(scenario) < curled) continue;
    if (phi <= largest * (1 + round_off)) densities.push_back(phi);
  }
  return densities;
}

Comparison compare(const std::vector<ComparedRun>& runs) {
  Comparison result;
  result.largest_density = std::numeric_limits<double>::infinity();
  for (const ComparedRun& run : runs) {
    const double end = run.history.empty() ? 0 : run.history.back().packing_density;
    result.largest_density = std::min(result.largest_density, end);
  }
  const Scenario& scenario = runs.front().scenario;
  const double a = scenario.wire.radius;
  result.window = averaging_window(scenario);
  result.densities = compared_densities(scenario, result.largest_density);
  if (result.densities.empty()) {
    throw InvalidInput(
        "the runs end before there is a density to compare at: the common range must reach beyond "
        "a length of 4 R, where the wire has curled up; give a larger density");
  }

  const Units units = units_of(scenario);
  const auto add = [&](std::string name, std::string unit, double tolerance, bool relative,
                       const Reading& reading) -> ComparedQuantity& {
    return result.quantities.emplace_back(quantity(runs, result.densities, std::move(name),
                                                   std::move(unit), tolerance, relative, reading));
  };
  const auto rows = [&](auto of) { return mean_of_rows(result.window, of); };
  const SpoolModel spool{scenario.cavity, a, units.bend, SpoolModel::seen_spacing * a};
  result.quantities.reserve(8);
  ComparedQuantity& energy =
      add("bend_energy", "YI/R", 0.03, true,
          rows([=](auto&, const HistoryRow& r) { return r.energy_bend / units.scaled_energy(); }));
  add_spool(energy, result.densities, spool, &SpoolModel::bend_energy, units.scaled_energy());
  add("twist_energy", "YI/R", 0.5, false,
      rows([=](auto&, const HistoryRow& r) { return r.energy_twist / units.scaled_energy(); }));
  ComparedQuantity& force = add("scaled_force", "YI/R^2", 0.05, true,
                                rows([](auto&, const HistoryRow& r) { return r.scaled_force; }));
  add_spool(force, result.densities, spool, &SpoolModel::injection_force, units.scaled_force());
  add("axis_order", "", 0.05, false, of_frame(result.window, axis_order));
  add("strand_spacing", "a", 0.03, true, of_frame(result.window, spacing_of));
  add("contacts_per_length", "1/a", 0.1, true,
      rows([=](auto&, const HistoryRow& r) { return r.contacts / r.inserted_length * a; }));
  add("max_overlap", "a", 0.05, false,
      rows([=](auto&, const HistoryRow& r) { return r.max_overlap / a; }));

  std::erase_if(result.quantities, [](const ComparedQuantity& q) {
    return std::all_of(q.values.begin(), q.values.end(), [](const auto& values) {
      return std::all_of(values.begin(), values.end(), [](const auto& v) { return !v; });
    });
  });

  for (const auto& [way, name] : ways) {
    const auto has = std::any_of(runs.begin(), runs.end(),
                                 [w = way](const ComparedRun& run) { return run.way == w; });
    if (!has) continue;
    if (rubs(way)) result.budgets.push_back(budget_of(runs, way, result.largest_density));
    result.costs.push_back(cost_of(runs, way, result.largest_density));
  }
  return result;
}

}  // namespace wirepack
