#include <gtest/gtest.h>

#include "wirepack/contact/cavity.hpp"
#include "wirepack/packing/imperfection.hpp"

namespace wirepack {
namespace {

Scenario with_nozzle(const NozzleOptions& nozzle, const Cavity& cavity = {10}) {
  Scenario scenario = default_scenario(Setup::low_torsion, cavity);
  scenario.nozzle = nozzle;
  return scenario;
}

Nozzle nozzle_of(const NozzleOptions& nozzle, const Cavity& cavity = {10}) {
  return drawn_setup(with_nozzle(nozzle, cavity)).nozzle;
}

TEST(Nozzle, at_a_place_of_the_wall_feeds_along_the_inward_normal) {
  const Vec3 place = 9 * Vec3(2, -1, 2).normalized();
  const Nozzle nozzle = nozzle_of({.position = place});
  EXPECT_EQ(nozzle.position, place);
  EXPECT_LT((nozzle.direction - place / 9).norm(), 1e-14);
}

TEST(Nozzle, reaches_its_depth_into_the_cavity_along_its_direction) {
  const Nozzle straight = nozzle_of({.depth = 3});
  EXPECT_LT((straight.position - Vec3(0, 0, 6)).norm(), 1e-14);
  const Vec3 oblique = Vec3(0.6, 0, -0.8);
  const Nozzle nozzle = nozzle_of({.direction = 7 * oblique, .depth = 2});
  EXPECT_LT((nozzle.direction + oblique).norm(), 1e-14);
  EXPECT_LT((nozzle.position - (Vec3(0, 0, 9) + 2 * oblique)).norm(), 1e-14);
}

TEST(Nozzle, of_a_seed_stays_at_the_wall_it_was_put_on) {
  for (const Cavity& cavity : {Cavity{10}, ellipsoid({12, 10, 9})}) {
    Scenario scenario = with_nozzle({}, cavity);
    scenario.nozzle.position = touching_point(cavity, Vec3(1, 2, -1), 1);
    scenario.imperfection = {0, 1.5, 0};
    double farthest = 0;
    for (scenario.seed = 1; scenario.seed <= 40; ++scenario.seed) {
      const Vec3 drawn = drawn_setup(scenario).nozzle.position;
      EXPECT_NEAR(wall_gap(cavity, drawn, 1), 0, 1e-9);
      farthest = std::max(farthest, (drawn - *scenario.nozzle.position).norm());
    }
    EXPECT_GT(farthest, 1);
    EXPECT_LT(farthest, 1.5 * 1.2);  // an ellipsoid's wall is not square to the ray
  }
}

// What is said about an impossible nozzle.
void expect_refused(const NozzleOptions& nozzle, const std::string& said) {
  const std::vector<std::string> found = problems(with_nozzle(nozzle));
  ASSERT_EQ(found.size(), 1U) << said;
  EXPECT_NE(found.front().find(said), std::string::npos) << found.front();
}

TEST(Nozzle, that_is_outside_or_feeds_the_wire_out_is_refused) {
  EXPECT_TRUE(problems(with_nozzle({})).empty());
  EXPECT_TRUE(problems(with_nozzle({.position = Vec3(9, 1e-17, 0)})).empty());
  EXPECT_TRUE(problems(with_nozzle({.direction = Vec3(0, 0, -1e300)})).empty());
  expect_refused({.position = Vec3(10, 0, 0)}, "it touches the wall at [9, 0, 0]");
  expect_refused({.position = Vec3::Zero()}, "needs nozzle.direction");
  EXPECT_TRUE(
      problems(with_nozzle({.position = Vec3::Zero(), .direction = Vec3::UnitX()})).empty());
  expect_refused({.direction = Vec3::Zero()}, "not all 0");
  expect_refused({.direction = Vec3::UnitZ()}, "leads out of the cavity");
  expect_refused({.position = Vec3(1e300, 0, 0)}, "it touches the wall at [9, 0, 0]");
  expect_refused({.direction = Vec3(0, 0, 1e300)}, "leads out of the cavity");
  expect_refused({.depth = -1}, "must be finite and not negative");
  EXPECT_TRUE(problems(with_nozzle({.depth = 15})).empty());
  expect_refused({.depth = 17}, "no room for the first two edges");
}

}  // namespace
}  // namespace wirepack
