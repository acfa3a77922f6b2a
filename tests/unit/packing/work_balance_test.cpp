#include "wirepack/packing/work_balance.hpp"

#include <gtest/gtest.h>

namespace wirepack {
namespace {

constexpr double unit = 1;

WorkStep step(double before, double after, double spent, bool whole_edge = false) {
  return {0.5, before, after, spent, unit, whole_edge};
}

TEST(WorkBalance, WhatNoForceBetweenBothEndsCouldDoIsReleasedInASnap) {
  WorkBalance balance;
  balance.work = 100;
  WorkErrors errors;
  // at 2 and 3 the work is 1.25, and at least 1 without a snap
  const WorkBooking snap = book(step(2, 3, 0.9), balance, errors);
  EXPECT_DOUBLE_EQ(snap.released, 0.35);
  EXPECT_TRUE(snap.resolved);
  EXPECT_DOUBLE_EQ(balance.work, 101.25);
  EXPECT_DOUBLE_EQ(balance.released, 0.35);
  EXPECT_EQ(errors.trapezoid, 0);
}

TEST(WorkBalance, AKinkIsAnErrorThatIsLeftWhileAllErrorsAreHalfAPercentOfTheWork) {
  WorkBalance balance;
  balance.work = 100;
  WorkErrors errors;
  for (int k = 1; k <= 6; ++k) {
    const WorkBooking kink = book(step(2, 3, 1.15), balance, errors);
    EXPECT_EQ(kink.released, 0);
    EXPECT_EQ(kink.resolved, k < 6) << k;  // 0.1 each, of 0.5 and a little
    EXPECT_NEAR(errors.trapezoid, 0.1 * k, 1e-14);
  }
  EXPECT_TRUE(book(step(2, 3, 1.35), balance, errors).resolved);  // the other way is welcome
  EXPECT_TRUE(book(step(2, 2, 0.99), balance, errors).resolved);  // and 1 % is no matter
}

TEST(WorkBalance, BesideTheSteadyErrorOfWholeEdgesOthersMayBeAThirdOfAPercentOfTheWork) {
  for (const double edge_share : {0.0, 0.01}) {
    WorkBalance balance;
    balance.work = 100;
    WorkErrors errors{.edge_share = edge_share, .trapezoid = 0.3};
    EXPECT_EQ(book(step(2, 3, 1.15), balance, errors).resolved, edge_share == 0);
  }
}

TEST(WorkBalance, WholeEdgesAreLeftOnceTheirErrorsWouldExceedWhatAllMay) {
  const double length = 0.5, force = 2;
  WorkBalance balance;
  balance.work = 100;
  WorkErrors errors;
  EXPECT_TRUE(whole_edge_is_likely_resolved(length, force, unit, balance, errors));
  book(step(force, force, 1.3, true), balance, errors);  // 0.3 of the work more than it should
  book(step(force, force, 1.3, true), balance, errors);
  EXPECT_NEAR(errors.edge_scatter, 0.06, 1e-12);  // twice the scatter before, and 0.02
  errors.trapezoid = -0.2;
  EXPECT_TRUE(whole_edge_is_likely_resolved(length, force, unit, balance, errors));
  errors.trapezoid = -0.25;  // 0.06 more are beyond 0.3 %
  EXPECT_FALSE(whole_edge_is_likely_resolved(length, force, unit, balance, errors));
  EXPECT_TRUE(whole_edge_is_likely_resolved(length, force / 3, unit, balance, errors));
}

TEST(WorkBalance, ASnapTellsLittleOfTheEdgesAfterItAndPartsOfEdgesMakeItForgotten) {
  WorkBalance balance;
  WorkErrors errors;
  book(step(2, 2, -20, true), balance, errors);
  EXPECT_NEAR(errors.edge_scatter, 0.02, 1e-12);
  errors.edge_scatter = 0.6;
  book(step(2, 2, 1, true), balance, errors);
  EXPECT_NEAR(errors.edge_scatter, 0.6 * 7 / 8, 0.01);
  const double before = errors.edge_scatter;
  for (int k = 0; k < 64; ++k) book(step(2, 2, 1), balance, errors);
  EXPECT_NEAR(errors.edge_scatter, before * 0.365, 0.002);  // (63/64)^64
}

TEST(WorkBalance, AFirstSnapIsFollowedInHalvesUntilItsSizeIsKnown) {
  WorkBalance balance;
  WorkErrors errors;
  EXPECT_FALSE(book({0.5, 6, 1, -1, unit, false}, balance, errors).resolved);
  EXPECT_TRUE(book({0.5, 1.01, 1, -1, unit, false}, balance, errors).resolved);
}

TEST(WorkBalance, ASplitThatTakesMoreThanATenthOfTheWorkOverAnEdgeHasSetOffASnap) {
  WorkBalance balance;
  EXPECT_EQ(book_split(0.05, 1, balance), 0);
  EXPECT_EQ(book_split(-0.3, 1, balance), 0);
  EXPECT_EQ(book_split(0.2, 1, balance), 0.2);
  EXPECT_DOUBLE_EQ(balance.remeshing, -0.25);
  EXPECT_EQ(balance.released, 0.2);
}

TEST(WorkBalance, TheMeshMayKeepTwoPercentOfWholeEdgesAndWhatIsMoreIsAnError) {
  WorkBalance balance;
  balance.work = 100;
  WorkErrors errors;
  for (int k = 0; k < 60; ++k) book(step(2, 2, 1.01, true), balance, errors);
  EXPECT_NEAR(errors.edge_share, -0.01, 1e-5);
  EXPECT_NEAR(errors.trapezoid, -0.01 * 8, 1e-3);  // until the mean was known
  errors = {};
  EXPECT_EQ(book(step(2, 2, 0.5, true), balance, errors).released, 0);
  EXPECT_DOUBLE_EQ(errors.trapezoid, 0.5);
  for (int k = 0; k < 100; ++k) book(step(2, 2, 0.5, true), balance, errors);
  EXPECT_NEAR(errors.edge_share, 0.02, 1e-5);
}

}  // namespace
}  // namespace wirepack
