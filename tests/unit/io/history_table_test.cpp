#include "wirepack/io/history_table.hpp"

#include <gtest/gtest.h>
#include <sstream>

namespace wirepack {
namespace {

TEST(HistoryTable, columns_are_scaled_as_the_header_says) {
  // a = 2, Y = 3, R = 10: YI = 12 pi, YI / R^2 = 0.12 pi, YI / R = 1.2 pi
  const Scenario scenario = default_scenario(Setup::low_torsion, Cavity{10}, /*wire_radius=*/2, 3);
  HistoryRow row;
  row.increment = 12;
  row.inserted_length = 30;
  row.packing_density = 0.125;
  row.scaled_force = 2.5;
  row.force_difference = 0.36 * pi;
  row.energy_bend = 4.8 * pi;
  row.energy_twist = 0.6 * pi;
  row.residual = 5e-5;
  row.evaluations = 77;
  row.contacts = 9;
  row.max_overlap = 0.02;
  PackingProgress progress;
  progress.snaps = 3;
  std::istringstream line(HistoryTable(scenario).line(row, progress));
  const double expected[] = {12, 15, 0.125, 2.5, 3, 4, 0.5, 3, 5e-5, 77, 9, 0.01};
  for (const double value : expected) {
    double shown = 0;
    line >> shown;
    EXPECT_NEAR(shown, value, 1e-4 * value);  // five digits are shown
  }
  std::string rest;
  line >> rest;
  EXPECT_TRUE(rest.empty());
}

TEST(HistoryTable, header_and_lines_are_aligned) {
  const HistoryTable table(default_scenario(Setup::low_torsion, Cavity{10}));
  const std::string header = table.header();
  const std::string line = table.line(HistoryRow{}, PackingProgress{});
  EXPECT_EQ(header.find('\n') + 1, line.size());
  EXPECT_EQ(header.size(), 2 * line.size());
}

}  // namespace
}  // namespace wirepack
