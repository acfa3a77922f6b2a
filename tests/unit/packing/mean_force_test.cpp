#include "wirepack/packing/mean_force.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/core/types.hpp"

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

}  // namespace
}  // namespace wirepack
