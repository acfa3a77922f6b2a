#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

#include "wirepack/io/sweep_plan.hpp"
#include "wirepack/packing/mean_force.hpp"
#include "wirepack/packing/packing_run.hpp"

namespace wirepack {
namespace {

const std::string data = std::string(WIREPACK_REFERENCE_DIR) + "/../";

struct Published {
  double phi_max = NAN, scatter = NAN;  // mean and standard deviation over seeds
};

// A point of data/paper/phi_max_10.csv.
Published published(const std::string& setup, double a_over_radius) {
  std::ifstream file(data + "paper/phi_max_10.csv");
  for (std::string line; std::getline(file, line);) {
    for (char& c : line) c = c == ',' ? ' ' : c;
    std::istringstream text(line);
    std::string name;
    double ratio = 0, phi_max = 0, standard_error = 0, runs = 0;
    text >> name >> ratio >> phi_max >> standard_error >> runs;
    if (text && name == setup && std::abs(ratio - a_over_radius) < 1e-6) {
      return {phi_max, standard_error * std::sqrt(runs)};
    }
  }
  return {};
}

// Density at which F R^2 / YI, as a mean over an edge, reaches 10 after the first coil.
double phi_max_of(Scenario scenario) {
  constexpr double threshold = 10;
  scenario.stop.scaled_force = threshold;
  PackingRun packing(scenario);
  std::vector<HistoryRow> history;
  for (Advance step; !step.stop;) {
    step = packing.advance();
    if (step.row) history.push_back(*step.row);
  }
  return density_at_force(mean_forces(scenario, history), threshold * force_unit(scenario))
      .value_or(NAN);
}

// The cheapest points of the curve in data/docs/paper.md, with friction, by the plan it is made by.
TEST(PaperCurve, is_repeated_at_the_smallest_cavity_within_the_scatter_of_seeds) {
  int repeated = 0;
  for (const SweepTask& task : read_sweep(data + "scenarios/paper.toml").tasks) {
    if (task.scenario.cavity.radius != 4 || task.scenario.seed != 1) continue;
    const bool low = task.scenario.setup == Setup::low_torsion;
    const Published point = published(low ? "low_torsion" : "high_torsion", 0.25);
    EXPECT_NEAR(phi_max_of(task.scenario), point.phi_max, 3 * point.scatter) << task.name;
    ++repeated;
  }
  EXPECT_EQ(repeated, 2);
}

}  // namespace
}  // namespace wirepack
