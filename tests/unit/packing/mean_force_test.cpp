#include "wirepack/packing/mean_force.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/core/types.hpp"
#include "wirepack/packing/observation.hpp"
#include "wirepack/packing/stop_rule.hpp"

namespace wirepack {
namespace {

// Readings every `increment` up to `length` of a force with this law.
template <class F>
std::vector<ForceReading> readings(double increment, double length, double edge_length, F&& force) {
  std::vector<ForceReading> recent;
  HistoryRow row;
  for (int k = 1; row.inserted_length < length - 1e-9; ++k) {
    row.inserted_length = increment * k;
    row.force = force(row.inserted_length);
    note_force(edge_length, row, recent);
  }
  return recent;
}

TEST(MeanForce, RippleOfOneEdgeLengthIsGoneWhateverThePhaseAndTheIncrement) {
  const auto ripple = [](double length) { return 3 + std::sin(2 * pi * length / 2); };
  for (const double increment : {0.1, 0.25, 0.4}) {
    for (const double length : {8.0, 8.4, 9.2}) {
      const auto recent = readings(increment, length, 2, ripple);
      // trapezoids of a whole cycle; where increments do not fit into it, cut at its start
      EXPECT_NEAR(*mean_force(2, recent), 3, increment * increment) << increment << ", " << length;
      EXPECT_LE(recent.size(), 2 / increment + 3);
    }
  }
}

TEST(MeanForce, OfALineIsItsValueHalfAnEdgeBack) {
  const auto line = [](double length) { return 5 * length; };
  EXPECT_NEAR(*mean_force(2, readings(0.5, 7, 2, line)), 5 * 6, 1e-9);
  EXPECT_NEAR(*mean_force(2, readings(0.3, 6, 2, line)), 5 * 5, 1e-9);
}

TEST(MeanForce, OfWholeEdgesIsTheReading) {
  EXPECT_EQ(mean_force(2, readings(2, 8, 2, [](double length) { return length; })), 8);
}

TEST(MeanForce, IsNotKnownBeforeAnEdgeLengthHasBeenFed) {
  const auto one = [](double) { return 1.0; };
  EXPECT_FALSE(mean_force(2, {}));
  EXPECT_FALSE(mean_force(2, readings(0.5, 2, 2, one)));
  EXPECT_NEAR(mean_force(2, readings(0.5, 2.5, 2, one)).value(), 1, 1e-12);
}

// A single peak of the ripple is no limit, its mean is.
TEST(MeanForce, IsWhatLimitsOfTheForceAndCrossingsAskFor) {
  Scenario scenario = default_scenario(Setup::low_torsion, {10});
  scenario.stop = {};
  scenario.stop.scaled_force = 10;
  const auto run = [&](double mean) {
    PackingProgress progress;
    std::optional<StopReason> reason;
    for (int k = 1; k <= 12 && !reason; ++k) {
      const double ripple = k % 2 == 0 ? 4 : -4;  // two increments an edge
      progress.last.inserted_length = k * scenario.wire.edge_length / 2;
      progress.last.force = (mean + ripple) * force_unit(scenario);
      note_force(scenario, progress);
      reason = reached_limit(scenario, progress);
    }
    EXPECT_NEAR(progress.scaled_crossings.back().level,
                std::pow(10, std::floor(2 * std::log10(mean)) / 2), 1e-12);
    return reason;
  };
  EXPECT_FALSE(run(9.5));
  EXPECT_EQ(run(10.5), StopReason::scaled_force);
}

}  // namespace
}  // namespace wirepack
