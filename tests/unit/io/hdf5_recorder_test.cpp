#include "wirepack/io/hdf5_recorder.hpp"

#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "wirepack/core/error.hpp"
#include "wirepack/io/config_file.hpp"
#include "wirepack/io/hdf5_reader.hpp"

#include "../../support/sample_rods.hpp"
#include "../../support/temporary_folder.hpp"

namespace wirepack {
namespace {

class Hdf5File : public ::testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "run.h5"; }
  std::size_t files_in_folder() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_.path()), {}));
  }

  testing::TemporaryFolder folder_;
  // a run that has every column
  Scenario scenario_ = default_scenario(Setup::high_torsion, Cavity{5}, 1, 5, Method::dynamic);
};

HistoryRow row_of(int increment) {
  HistoryRow row;
  for (const HistoryColumn& column : history_columns) {
    row.*column.value =
        column.integer ? increment * 3 : increment / 7.0 + static_cast<double>(column.name.size());
  }
  row.increment = increment;
  return row;
}

RodState rod_of(Index nodes) {
  RodState rod = testing::random_rod(nodes, RodParams{}, {.last_clamped = true}, 5);
  rod.inlet_rest_length = 1.1 / 3;
  double twist = 0;
  for (double& guide : rod.twist_guide) guide = twist += 0.1;
  return rod;
}

PackingProgress progress_of(int increment, Index nodes) {
  PackingProgress p;
  p.rod = rod_of(nodes);
  p.last = row_of(increment);
  p.balance = {1.0 / 3, 2.0 / 3, -1e-17};
  p.random_state = 0xFEDCBA9876543210u;
  p.substep = 0.125;
  p.work_errors.edge_share = -0.02 / 3;
  p.work_errors.edge_scatter = 0.2 / 3;
  p.work_errors.trapezoid = 0.1 / 7;
  p.last_frame_density = 0.3;
  p.recent_forces = {{1.0 / 3, 0.1}, {2.0 / 3, 0.7}};
  p.scaled_crossings = {{1, 0.1}, {std::sqrt(10.0), 0.2}};
  p.snaps = 4;
  p.rollbacks = 5;
  p.work = {.evaluations = 12, .factorizations = 3, .rounds_taken_back = 1, .list_builds = 2};
  p.work.solve_seconds = 1.0 / 3;
  return p;
}

PackingFrame frame_of(int increment, Index nodes) {
  PackingFrame frame;
  frame.rod = rod_of(nodes);
  frame.increment = increment;
  frame.inserted_length = 12.5;
  frame.packing_density = 0.25;
  frame.force = 1.0 / 3;
  frame.bend_energy = Eigen::VectorXd::LinSpaced(nodes, 0, 1);
  frame.twist_energy = Eigen::VectorXd::LinSpaced(nodes, 1, 2);
  frame.wall_force = Eigen::VectorXd::LinSpaced(nodes, 2, 3);
  SelfContact contact{};
  contact.edges = {1, 4};
  contact.force = 0.7;
  frame.contacts = {contact, contact};
  frame.contacts[1].edges = {2, 5};
  return frame;
}

void expect_equal_rods(const RodState& a, const RodState& b) {
  EXPECT_EQ(a.nodes, b.nodes);
  ASSERT_EQ(a.frames.size(), b.frames.size());
  for (std::size_t j = 0; j < a.frames.size(); ++j) {
    EXPECT_EQ(a.frames[j].coeffs(), b.frames[j].coeffs());
  }
  EXPECT_EQ(a.twist_guide, b.twist_guide);
  EXPECT_EQ(a.ends.closed, b.ends.closed);
  EXPECT_EQ(a.ends.first_clamped, b.ends.first_clamped);
  EXPECT_EQ(a.ends.last_clamped, b.ends.last_clamped);
  EXPECT_EQ(a.inlet_rest_length, b.inlet_rest_length);
}

TEST_F(Hdf5File, progress_comes_back_bit_for_bit_also_when_it_was_replaced) {
  Hdf5Recorder recorder(file(), scenario_, "test");
  recorder.flush(progress_of(0, 20));
  int increment = 0;
  for (const Index nodes : {40, 600, 30}) {
    recorder.add(row_of(++increment));
    PackingProgress p = progress_of(increment, nodes);
    p.absolute_crossings.assign(static_cast<std::size_t>(nodes), {2, 0.3});
    recorder.flush(p);
    const PackingProgress back = Hdf5Reader(file()).progress();
    expect_equal_rods(back.rod, p.rod);
    for (const HistoryColumn& column : history_columns) {
      EXPECT_EQ(back.last.*column.value, p.last.*column.value) << column.name;
    }
    EXPECT_EQ(back.balance.work, p.balance.work);
    EXPECT_EQ(back.balance.released, p.balance.released);
    EXPECT_EQ(back.balance.remeshing, p.balance.remeshing);
    EXPECT_EQ(back.random_state, p.random_state);
    EXPECT_EQ(back.substep, p.substep);
    EXPECT_EQ(back.work_errors.edge_share, p.work_errors.edge_share);
    EXPECT_EQ(back.work_errors.edge_scatter, p.work_errors.edge_scatter);
    EXPECT_EQ(back.work_errors.trapezoid, p.work_errors.trapezoid);
    EXPECT_EQ(back.last_frame_density, p.last_frame_density);
    ASSERT_EQ(back.recent_forces.size(), 2u);
    EXPECT_EQ(back.recent_forces[1].inserted_length, 2.0 / 3);
    EXPECT_EQ(back.recent_forces[1].force, 0.7);
    ASSERT_EQ(back.scaled_crossings.size(), 2u);
    EXPECT_EQ(back.scaled_crossings[1].level, std::sqrt(10.0));
    EXPECT_EQ(back.scaled_crossings[1].packing_density, 0.2);
    EXPECT_EQ(back.absolute_crossings.size(), p.absolute_crossings.size());
    EXPECT_EQ(back.snaps, p.snaps);
    EXPECT_EQ(back.rollbacks, p.rollbacks);
    for (const auto& entry : work_counts) {
      EXPECT_EQ(back.work.*entry.value, p.work.*entry.value) << entry.name;
    }
    for (const auto& entry : work_seconds) {
      EXPECT_EQ(back.work.*entry.value, p.work.*entry.value) << entry.name;
    }
  }
}

TEST_F(Hdf5File, rows_of_many_flushes_come_back_in_order) {
  Hdf5Recorder recorder(file(), scenario_, "test");
  int increment = 0;
  for (const int count : {0, 1, 300, 2, 700}) {
    for (int i = 0; i < count; ++i) recorder.add(row_of(++increment));
    recorder.flush(progress_of(increment, 20));
  }
  const std::vector<HistoryRow> rows = Hdf5Reader(file()).history();
  ASSERT_EQ(rows.size(), 1003u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const HistoryRow expected = row_of(static_cast<int>(i) + 1);
    for (const HistoryColumn& column : history_columns) {
      ASSERT_EQ(rows[i].*column.value, expected.*column.value) << column.name << " " << i;
    }
  }
}

TEST_F(Hdf5File, a_run_without_friction_and_inertia_has_none_of_their_columns) {
  const Scenario plain = default_scenario(Setup::high_torsion, Cavity{5});
  Hdf5Recorder recorder(file(), plain, "test");
  recorder.add(row_of(1));
  recorder.flush(progress_of(1, 20));
  const HistoryRow row = Hdf5Reader(file()).history().front();
  EXPECT_EQ(row.energy_bend, row_of(1).energy_bend);
  EXPECT_EQ(row.friction_dissipation, 0);
  EXPECT_EQ(row.work, 0);
}

TEST_F(Hdf5File, frames_come_back) {
  Hdf5Recorder recorder(file(), scenario_, "test");
  recorder.add(frame_of(12, 9));
  recorder.flush(progress_of(12, 20));
  recorder.add(frame_of(1234567, 8));
  PackingFrame lonely = frame_of(3, 7);
  lonely.contacts.clear();
  recorder.add(lonely);
  recorder.add(frame_of(12, 10));
  recorder.flush(progress_of(13, 20));
  const Hdf5Reader reader(file());
  EXPECT_EQ(reader.frame_increments(), (std::vector<std::int64_t>{3, 12, 1234567}));
  EXPECT_TRUE(reader.frame(3).contacts.empty());
  const PackingFrame expected = frame_of(12, 10);
  const PackingFrame back = reader.frame(12);
  EXPECT_EQ(back.rod.nodes, expected.rod.nodes);
  ASSERT_EQ(back.rod.frames.size(), 9u);
  EXPECT_EQ(back.rod.frames[8].coeffs(), expected.rod.frames[8].coeffs());
  EXPECT_EQ(back.bend_energy, expected.bend_energy);
  EXPECT_EQ(back.twist_energy, expected.twist_energy);
  EXPECT_EQ(back.wall_force, expected.wall_force);
  EXPECT_EQ(back.force, expected.force);
  EXPECT_EQ(back.increment, 12);
  EXPECT_EQ(back.inserted_length, expected.inserted_length);
  EXPECT_EQ(back.packing_density, expected.packing_density);
  ASSERT_EQ(back.contacts.size(), 2u);
  EXPECT_EQ(back.contacts[1].edges.first, 2);
  EXPECT_EQ(back.contacts[1].edges.second, 5);
  EXPECT_EQ(back.contacts[1].force, 0.7);
  EXPECT_THROW(reader.frame(4), FileError);
}

TEST_F(Hdf5File, a_continued_file_keeps_what_it_has) {
  Hdf5Recorder first(file(), scenario_, "first call");
  first.add(row_of(1));
  first.add(frame_of(1, 9));
  first.flush(progress_of(1, 20), StopReason::length);
  EXPECT_TRUE(Hdf5Reader(file()).finished());
  EXPECT_EQ(Hdf5Reader(file()).stop_reason(), "length");
  scenario_.stop.length = 77;
  Hdf5Recorder second =
      Hdf5Recorder::continuing(file(), scenario_, "second call", progress_of(1, 20));
  second.add(row_of(2));
  second.add(frame_of(2, 9));
  second.flush(progress_of(2, 20));
  const Hdf5Reader reader(file());
  EXPECT_EQ(reader.history().size(), 2u);
  EXPECT_EQ(reader.frame_increments().size(), 2u);
  EXPECT_FALSE(reader.finished());
  EXPECT_EQ(reader.stop_reason(), "");
  EXPECT_EQ(reader.command_line(), "first call\nsecond call");
  EXPECT_EQ(reader.config(), resolved_config(scenario_));
  EXPECT_EQ(reader.scenario().stop.length, 77);
}

TEST_F(Hdf5File, many_flushes_do_not_make_the_file_grow) {
  Hdf5Recorder recorder(file(), scenario_, "test");
  for (int i = 0; i < 3; ++i) recorder.flush(progress_of(i, 500));
  const auto before = std::filesystem::file_size(file());
  for (int i = 3; i < 100; ++i) recorder.flush(progress_of(i, 500));
  EXPECT_EQ(std::filesystem::file_size(file()), before);
}

TEST_F(Hdf5File, what_could_not_be_written_is_written_by_the_next_flush) {
  Hdf5Recorder recorder(file(), scenario_, "test");
  recorder.add(row_of(1));
  recorder.flush(progress_of(1, 20));
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit full = before;
  full.rlim_cur = 20000;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &full), 0);
  recorder.add(row_of(2));
  recorder.add(frame_of(2, 2000));
  EXPECT_THROW(recorder.flush(progress_of(2, 2000)), FileError);
  EXPECT_EQ(Hdf5Reader(file()).history().size(), 1u);
  EXPECT_EQ(files_in_folder(), 1u);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  recorder.flush(progress_of(2, 2000));
  EXPECT_EQ(Hdf5Reader(file()).history().size(), 2u);
  EXPECT_EQ(Hdf5Reader(file()).frame(2).rod.node_count(), 2000);
}

TEST_F(Hdf5File, a_target_that_cannot_be_replaced_is_an_error_and_stays) {
  std::filesystem::create_directory(file());
  Hdf5Recorder recorder(file(), scenario_, "test");
  EXPECT_THROW(recorder.flush(progress_of(1, 20)), FileError);
  EXPECT_EQ(files_in_folder(), 1u);
  EXPECT_THROW(Hdf5Recorder(folder_ / "no" / "run.h5", scenario_, "").flush(progress_of(1, 20)),
               FileError);
  EXPECT_THROW(Hdf5Reader{folder_ / "none.h5"}, FileError);
  EXPECT_THROW(Hdf5Reader{folder_.path()}, FileError);
}

}  // namespace
}  // namespace wirepack
