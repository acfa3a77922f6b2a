#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

#include "wirepack/packing/quasistatic_packing.hpp"

namespace wirepack {
namespace {

struct Reference {
  double length, energy;
};

std::vector<Reference> read_reference(const std::string& name) {
  std::ifstream file(std::string(WIREPACK_REFERENCE_DIR) + "/" + name);
  std::vector<Reference> rows;
  for (std::string line; std::getline(file, line);) {
    Reference row{};
    char comma = 0;
    std::istringstream text(line);
    if (text >> row.length >> comma >> row.energy) rows.push_back(row);
  }
  return rows;
}

class StoredRun : public ::testing::TestWithParam<Setup> {};

// Early packings, up to the fifth coil, before small differences between machines grow.
TEST_P(StoredRun, IsReproduced) {
  const bool low = GetParam() == Setup::low_torsion;
  const std::vector<Reference> reference =
      read_reference(low ? "low_torsion_r5.csv" : "high_torsion_r5.csv");
  ASSERT_GE(reference.size(), 8U);
  Scenario scenario = default_scenario(GetParam(), {5});
  scenario.stop = {};
  scenario.stop.length = reference.back().length;
  QuasistaticPacking packing(scenario);
  HistoryRow before;
  std::size_t next = 0;
  for (bool going = true; going;) {
    going = !packing.advance().stop;
    const HistoryRow& row = packing.progress().last;
    for (; next < reference.size() && row.inserted_length >= reference[next].length - 1e-9;
         ++next) {
      const double part = (reference[next].length - before.inserted_length) /
                          (row.inserted_length - before.inserted_length);
      const double energy = before.energy_total + part * (row.energy_total - before.energy_total);
      EXPECT_NEAR(energy / reference[next].energy, 1, 0.003) << "at " << reference[next].length;
    }
    before = row;
  }
  EXPECT_EQ(next, reference.size());
}

INSTANTIATE_TEST_SUITE_P(Setups, StoredRun,
                         ::testing::Values(Setup::low_torsion, Setup::high_torsion));

}  // namespace
}  // namespace wirepack
