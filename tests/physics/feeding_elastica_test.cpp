#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "wirepack/packing/quasistatic_packing.hpp"
#include "wirepack/verify/fed_elastica.hpp"

namespace wirepack {
namespace {

// A stiff wire (50 times the stretching stiffness, so that it is nearly inextensible) fed through
// the pole of a sphere of R = 40 a, beside the exact planar elastica from the first contact of the
// tip to the second contact with the wall.
struct Feeding {
  std::vector<double> length, force, energy, work;
  double worst_early_force = 0;  // before contact
};

Scenario stiff_wire(double edge_length) {
  Scenario scenario = default_scenario(Setup::low_torsion, {40});
  scenario.wire.stretch_multiplier = 50;
  scenario.wire.edge_length = edge_length;
  scenario.insertion.increment = 0.5;
  scenario.stop.length = 128;
  scenario.wall_stiffness = 500;  // the tip's reaction on half an edge must not move the tip
  return scenario;
}

Feeding feed(const Scenario& scenario) {
  Feeding run;
  QuasistaticPacking packing(scenario);
  const double contact = 2 * (scenario.cavity.radius - scenario.wire.radius);
  std::optional<StopReason> stop;
  while (!stop) {
    stop = packing.advance().stop;
    const HistoryRow& row = packing.progress().last;
    if (row.inserted_length < contact - 1e-9) {
      run.worst_early_force = std::max(run.worst_early_force, std::abs(row.scaled_force));
    } else {
      run.length.push_back(row.inserted_length);
      run.force.push_back(row.force);
      run.energy.push_back(row.energy_total);
      run.work.push_back(packing.progress().balance.work);
    }
  }
  return run;
}

struct Deviation {
  double worst = 0, mean = 0;  // |F - exact| over the exact force
  double peak = 0, second_contact = 0;
  int compared = 0;
};

// From 1 a behind the buckling of the straight wire (where the force falls from the compression of
// an extensible wire to the elastica's) to the second contact.
Deviation compare(const Scenario& scenario, const Feeding& run) {
  const FedElastica exact{scenario.cavity.radius - scenario.wire.radius,
                          stiffness(scenario.wire).bend};
  FedElastica::Shape shape = exact.first_bent(0.05);
  Deviation deviation;
  for (std::size_t k = 0; k < run.length.size(); ++k) {
    if (run.length[k] < 2 * exact.rho + 1) continue;
    shape = exact.at_length(run.length[k], shape);
    if (shape.farthest > exact.rho) break;
    const double error = std::abs(run.force[k] / shape.force - 1);
    deviation.worst = std::max(deviation.worst, error);
    deviation.mean += error;
    deviation.peak = std::max(deviation.peak, run.force[k]);
    deviation.second_contact = run.length[k];
    ++deviation.compared;
  }
  deviation.mean /= deviation.compared;
  return deviation;
}

TEST(FedElastica, ForceIsTheDerivativeOfTheExactEnergy) {
  const FedElastica exact{39, 3.927};
  const FedElastica::Shape start = exact.first_bent(0.3);
  const FedElastica::Shape before = exact.at_length(start.length + 4.9, start);
  const FedElastica::Shape here = exact.at_length(start.length + 5, before);
  const FedElastica::Shape after = exact.at_length(start.length + 5.1, here);
  // central difference over 0.2: error of order (0.1 / 39)^2
  EXPECT_NEAR((after.energy - before.energy) / 0.2 / here.force, 1, 2e-5);
}

TEST(FedElastica, PackingFollowsTheExactForceFromFirstToSecondWallContact) {
  const Scenario scenario = stiff_wire(1);
  const Feeding run = feed(scenario);
  const Deviation deviation = compare(scenario, run);
  EXPECT_LT(run.worst_early_force, 1e-3);  // ten times the minimizer's tolerance
  EXPECT_GT(deviation.compared, 60);
  EXPECT_GT(deviation.second_contact, 120);
  EXPECT_LT(deviation.worst, 0.01);  // l = R / 40
  RecordProperty("worst", std::to_string(deviation.worst));
  RecordProperty("mean", std::to_string(deviation.mean));

  // the first peak: buckling of the straight wire between the clamp and the sliding tip
  const double unit = stiffness(scenario.wire).bend / 1600;
  EXPECT_NEAR(*std::max_element(run.force.begin(), run.force.end()) / unit, 4.806, 0.05);

  // int F dL equals the stored energy
  EXPECT_NEAR(run.work.back() / run.energy.back(), 1, 0.005);
}

TEST(FedElastica, ForceConvergesWithTheMesh) {
  const Scenario coarse = stiff_wire(2);
  const Scenario fine = stiff_wire(1);
  const double coarse_error = compare(coarse, feed(coarse)).mean;
  const double fine_error = compare(fine, feed(fine)).mean;
  EXPECT_LT(fine_error, 0.4 * coarse_error) << coarse_error << " -> " << fine_error;
}

}  // namespace
}  // namespace wirepack
