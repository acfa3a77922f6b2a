#include "wirepack/io/sweep_plan.hpp"

#include <gtest/gtest.h>

#include "wirepack/core/error.hpp"

namespace wirepack {
namespace {

std::vector<std::string> names(const std::string& plan) {
  std::vector<std::string> result;
  for (const SweepTask& task : parse_sweep(plan, "plan.toml").tasks) result.push_back(task.name);
  return result;
}

void expect_refused(const std::string& plan, const std::string& part) {
  try {
    parse_sweep(plan, "plan.toml");
    ADD_FAILURE() << "accepted: " << plan;
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

using Names = std::vector<std::string>;

TEST(SweepPlan, lists_are_combined_and_the_last_varies_fastest) {
  const Sweep sweep = parse_sweep(
      "[wire]\npoisson_ratio = 0.25\n[sweep]\npacking.setup = ['low_torsion', 'high_torsion']\n"
      "cavity.radius = [5, 7.5, 10]\npacking.seed = { from = 2, to = 3 }\n",
      "plan.toml");
  EXPECT_EQ(sweep.keys, (Names{"packing.setup", "cavity.radius", "packing.seed"}));
  ASSERT_EQ(sweep.tasks.size(), 12u);
  EXPECT_EQ(sweep.tasks[0].name, "setup=low_torsion,radius=5,seed=2");
  EXPECT_EQ(sweep.tasks[3].name, "setup=low_torsion,radius=7.5,seed=3");
  const SweepTask& last = sweep.tasks.back();
  EXPECT_EQ(last.values, (Names{"high_torsion", "10", "3"}));
  EXPECT_EQ(last.scenario.setup, Setup::high_torsion);
  EXPECT_EQ(last.scenario.cavity.radius, 10);
  EXPECT_EQ(last.scenario.seed, 3u);
  EXPECT_EQ(last.scenario.wire.poisson_ratio, 0.25);
  // what depends on a varied key follows it
  EXPECT_EQ(last.scenario.nozzle.twist, TwistCondition::locked);
}

TEST(SweepPlan, ranges_hit_both_ends) {
  const std::string sweep = "[sweep]\n";
  EXPECT_EQ(names(sweep + "wire.radius = { from = 0.1, to = 0.3, step = 0.1 }"),
            (Names{"radius=0.1", "radius=0.2", "radius=0.3"}));
  EXPECT_EQ(names(sweep + "cavity.radius = { from = 5, to = 10, count = 3 }"),
            (Names{"radius=5", "radius=7.5", "radius=10"}));
  EXPECT_EQ(names(sweep + "cavity.radius = { from = 4, to = 400, count = 3, spacing = 'log' }"),
            (Names{"radius=4", "radius=40", "radius=400"}));
  EXPECT_EQ(names(sweep + "packing.seed = { from = 5, to = 1, step = -2 }"),
            (Names{"seed=5", "seed=3", "seed=1"}));
}

TEST(SweepPlan, lists_of_a_zip_go_together) {
  const Sweep sweep = parse_sweep(
      "[[sweep.zip]]\ncavity.radius = [5, 10]\nwire.edge_length = [0.5, 1]\n", "plan.toml");
  ASSERT_EQ(sweep.tasks.size(), 2u);
  EXPECT_EQ(sweep.tasks[1].name, "radius=10,edge_length=1");
  EXPECT_EQ(sweep.tasks[0].scenario.wire.edge_length, 0.5);
  EXPECT_EQ(sweep.tasks[1].scenario.wire.edge_length, 1);
}

TEST(SweepPlan, cases_set_keys_of_their_own) {
  const Sweep sweep = parse_sweep(
      "[cavity]\nradius = 6\n[sweep]\npacking.seed = [1, 2]\n"
      "[sweep.cases.soft]\nwire.youngs_modulus = 1\n[sweep.cases.free]\ncontact.enabled = false\n",
      "plan.toml");
  ASSERT_EQ(sweep.tasks.size(), 4u);
  EXPECT_EQ(sweep.tasks[0].name, "seed=1,case=soft");
  EXPECT_EQ(sweep.tasks[0].scenario.wire.youngs_modulus, 1);
  EXPECT_TRUE(sweep.tasks[0].scenario.contact_enabled);
  EXPECT_EQ(sweep.tasks[3].values, (Names{"2", "free"}));
  EXPECT_FALSE(sweep.tasks[3].scenario.contact_enabled);
}

TEST(SweepPlan, names_tell_apart_keys_that_end_alike) {
  EXPECT_EQ(names("[sweep]\ncavity.radius = [8]\nwire.radius = [1, 2]\n"),
            (Names{"cavity.radius=8,wire.radius=1", "cavity.radius=8,wire.radius=2"}));
}

TEST(SweepPlan, what_is_wrong_is_told_with_its_place) {
  expect_refused("[cavity]\nradius = 5\n", "plan.toml: has no [sweep]");
  expect_refused("[sweep]\ncavity.radius = [5, -1]\n", "plan.toml:2:21: cavity.radius = -1");
  expect_refused("[sweep]\ncavity.radios = [5]\n", "did you mean cavity.radius?");
  expect_refused("[sweep]\ncavity.radius = 5\n", "must be a list of values, or a range");
  expect_refused("[sweep]\ncavity.radius = []\n", "must be a list of values, or a range");
  expect_refused("[sweep]\ncavity.radius = [[1], [2]]\n", "lists have numbers, strings");
  expect_refused("[sweep]\n\"cavity.radius\" = [5]\n", "write it without quotes");
  expect_refused("[sweep]\ncavity.radius = { from = 1 }\n", "has no from and to");
  expect_refused("[sweep]\npacking.seed = { from = 1, to = 3, step = 0 }\n", "values");
  expect_refused("[sweep]\npacking.seed = { from = 1, to = 1e9 }\n", "values");
  expect_refused("[sweep]\ncavity.radius = { from = -1, to = 5, count = 3, spacing = 'log' }\n",
                 "must be positive");
  expect_refused("[[sweep.zip]]\ncavity.radius = [5, 10]\nwire.edge_length = [1]\n",
                 "lists of a zip are equally long");
  expect_refused("[sweep]\ncavity.radius = [5, 5]\n", "two tasks would have the name radius=5");
  expect_refused("[sweep]\ncavity.radius = [5]\n[sweep.cases.a]\ncavity.radius = 6\n",
                 "cavity.radius is given twice");
  expect_refused("base = 'missing.toml'\n[sweep]\ncavity.radius = [5]\n", "there is no such file");
  expect_refused("[sweep\n", "plan.toml:");
  expect_refused("seeds = 3\n[sweep]\ncavity.radius = [5]\n", "seeds");
}

TEST(SweepPlan, too_many_tasks_are_refused_before_they_are_made) {
  expect_refused(
      "[sweep]\npacking.seed = { from = 1, to = 1000 }\ncavity.radius = { from = 3, to = 1002 }\n",
      "more than 100000 tasks");
}

}  // namespace
}  // namespace wirepack
