#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wirepack/packing/history.hpp"
#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// The ways to pack that are set side by side.
enum class Way { quasistatic, dynamic, quasistatic_friction, dynamic_friction };
inline constexpr std::array<std::pair<Way, std::string_view>, 4> ways{{
    {Way::quasistatic, "quasistatic"},
    {Way::dynamic, "dynamic"},
    {Way::quasistatic_friction, "quasistatic_friction"},
    {Way::dynamic_friction, "dynamic_friction"},
}};
/// The scenario packed in this way; its method and model of friction do not count.
Scenario scenario_of(Way way, Scenario scenario);

/// One finished run.
struct ComparedRun {
  Way way;
  Scenario scenario;
  std::vector<HistoryRow> history;
  std::vector<PackingFrame> frames;
};

/// Mean over seeds, with its standard error when there are several.
struct SeedMean {
  double mean = 0;
  double error = 0;
  int seeds = 0;
};

/// One quantity at the densities of the comparison, in each way; none where a way has no value
/// there.
struct ComparedQuantity {
  std::string name, unit;
  double tolerance;  ///< between dynamic and quasistatic without friction
  bool relative;     ///< tolerance and difference over the quasi-static value, else plain
  std::array<std::vector<std::optional<SeedMean>>, ways.size()> values;
  std::vector<std::optional<double>> spool;  ///< inverse-spool model, where it has the quantity

  /// Dynamic minus quasi-static without friction, at each density where both are.
  std::vector<std::optional<double>> differences() const;
  /// Mean of those; none without any.
  std::optional<double> mean_difference() const;
};

/// Where the work of insertion went in a run with friction, per inserted length over the whole
/// common range [YI/R^2].
struct ForceBudget {
  Way way;
  double force = 0;     ///< mean injection force
  double stored = 0;    ///< change of elastic, contact and kinetic energy
  double released = 0;  ///< lost in jumps, of minimizations
  double friction = 0;  ///< dissipated by friction
  double viscous = 0;   ///< dissipated by viscous forces
};

struct Cost {
  Way way;
  double evaluations = 0;  ///< of energy and gradient, up to the end of the common range
  double seconds = 0;
};

struct Comparison {
  double largest_density = 0;     ///< end of the common range
  std::vector<double> densities;  ///< every 0.025 (below 0.1) or 0.05
  double window = 0;              ///< values are means over densities this far to both sides
  std::vector<ComparedQuantity> quantities;  ///< those that some run has
  std::vector<ForceBudget> budgets;          ///< of all runs with friction, mean over seeds
  std::vector<Cost> costs;                   ///< mean over seeds
};

/// Densities up to the largest at which runs are compared: those beyond which the wire has curled
/// up (4 R). None: the runs would end too early.
std::vector<double> compared_densities(const Scenario& scenario, double largest);

/// Sets runs of one scenario side by side, with several seeds or one. The common range ends where
/// the first of them does. Throws InvalidInput when that is before the wire has curled up (4 R).
Comparison compare(const std::vector<ComparedRun>& runs);

}  // namespace wirepack
