#include "wirepack/io/recorded_run.hpp"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "wirepack/core/error.hpp"
#include "wirepack/io/hdf5_reader.hpp"

#include "../../support/temporary_folder.hpp"

namespace wirepack {
namespace {

class RecordedRunTest : public ::testing::Test {
 protected:
  RecordedRunTest() {
    scenario_.stop = {};
    scenario_.stop.increments = 12;
  }

  std::filesystem::path file(const char* name) const { return folder_ / name; }
  std::vector<HistoryRow> rows(const char* name) const { return Hdf5Reader(file(name)).history(); }

  testing::TemporaryFolder folder_;
  Scenario scenario_ = default_scenario(Setup::high_torsion, {5});
};

TEST_F(RecordedRunTest, every_increment_is_told_once_and_is_in_the_file) {
  std::vector<double> told;
  RunHooks hooks;
  hooks.on_increment = [&](const HistoryRow& row, const PackingProgress&) {
    told.push_back(row.increment);
  };
  const RecordedRun run = run_recorded(scenario_, file("out.h5"), {}, hooks);
  EXPECT_EQ(run.stop, StopReason::increments);
  EXPECT_EQ(run.last.increment, 12);
  std::vector<double> kept;
  for (const HistoryRow& row : rows("out.h5")) kept.push_back(row.increment);
  EXPECT_EQ(kept, told);
  EXPECT_EQ(told.size(), 12U);
  EXPECT_EQ(told.back(), 12);
}

TEST_F(RecordedRunTest, stopped_on_request_goes_on_to_the_bits_of_an_undisturbed_one) {
  run_recorded(scenario_, file("whole.h5"));
  int left = 5;
  RunHooks hooks;
  hooks.stop_requested = [&] { return left-- == 0; };
  const RecordOptions go_on{.existing = Existing::go_on};
  EXPECT_FALSE(run_recorded(scenario_, file("parts.h5"), go_on, hooks).stop.has_value());
  EXPECT_EQ(rows("parts.h5").size(), 5U);
  const RecordedRun rest = run_recorded(scenario_, file("parts.h5"), go_on);
  EXPECT_FALSE(rest.was_over);
  const std::vector<HistoryRow> parts = rows("parts.h5"), whole = rows("whole.h5");
  ASSERT_EQ(parts.size(), whole.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_EQ(parts[i].energy_total, whole[i].energy_total);
    EXPECT_EQ(parts[i].force, whole[i].force);
  }
}

TEST_F(RecordedRunTest, a_result_at_its_end_is_given_back_and_goes_on_to_a_larger_limit) {
  const RecordedRun first = run_recorded(scenario_, file("out.h5"));
  const RecordOptions go_on{.existing = Existing::go_on};
  const RecordedRun again = run_recorded(scenario_, file("out.h5"), go_on);
  EXPECT_TRUE(again.was_over);
  EXPECT_EQ(again.last.energy_total, first.last.energy_total);
  EXPECT_EQ(again.totals.stored, first.totals.stored);
  scenario_.stop.increments = 14;
  EXPECT_EQ(run_recorded(scenario_, file("out.h5"), go_on).last.increment, 14);
}

TEST_F(RecordedRunTest, what_is_there_is_neither_replaced_nor_mixed_unasked) {
  run_recorded(scenario_, file("out.h5"));
  EXPECT_THROW(run_recorded(scenario_, file("out.h5")), InvalidInput);
  scenario_.wire.poisson_ratio = 0.2;
  EXPECT_THROW(run_recorded(scenario_, file("out.h5"), {.existing = Existing::go_on}),
               InvalidInput);
  scenario_.stop.increments = 3;
  run_recorded(scenario_, file("out.h5"), {.existing = Existing::replace});
  EXPECT_EQ(rows("out.h5").size(), 3U);
}

}  // namespace
}  // namespace wirepack
