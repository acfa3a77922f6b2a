#include "wirepack/solve/equilibrium.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

#include "wirepack/core/error.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/load_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/solve/minimizer.hpp"

#include "../../support/clamped_rod.hpp"

namespace wirepack {
namespace {

RodParams wire_of(double radius) {
  RodParams params;
  params.radius = params.edge_length = radius;
  return params;
}

// A cantilever of 20 edges, clamped at its last node, pulled across at its tip.
struct Cantilever {
  double unit = 1;  // of length
  RodParams params = wire_of(unit);
  StretchEnergy stretch{params};
  JointEnergy joints{params};
  LoadEnergy load{params, Loads{{{0, Vec3(0.02 * unit * unit, 0, 0)}}, {}, Vec3::Zero()}};
  EnergyTerms energy{stretch, joints, load};
  testing::HeldRod straight = testing::clamped_rod(20, params, {.last_clamped = true});
  RodState rod = straight.rod;
  EquilibriumOptions options{1e-7, 1e-7, 4e-6, {}, {}, 0};

  EquilibriumReport rest() { return solve_equilibrium(rod, straight.held, energy, options); }
};

TEST(Equilibrium, CantileverBendsByTheTextbookAmountAndTheResidualIsMet) {
  Cantilever c;
  const EquilibriumReport report = c.rest();
  EXPECT_EQ(report.end, EquilibriumEnd::converged);
  EXPECT_LE(report.residual, 1);
  // P L^2 / B = 2.037: drop / L = 0.4984 (Bisshopp and Drucker 1945), order 2 in the mesh
  EXPECT_NEAR(c.rod.nodes(0, 0) / 20, 0.4984, 0.003);
}

TEST(Equilibrium, is_the_same_in_any_unit_of_length) {
  const auto rest_in = [](double unit) {
    Cantilever c{unit};
    c.options = equilibrium_options(stiffness(c.params).bend, unit, 1e-7 * unit * unit);
    c.options.exactness = 0.7;
    const EquilibriumReport report = c.rest();
    EXPECT_EQ(report.end, EquilibriumEnd::converged) << unit;
    return std::pair(double(report.energy) / std::pow(unit, 3), report.work.evaluations);
  };
  const auto one = rest_in(1);
  for (const double unit : {0x1p-30, 0x1p-10, 0x1p30}) {
    EXPECT_EQ(rest_in(unit), one) << unit;
  }
  for (const double unit : {1e-9, 125.0, 1e6}) {
    EXPECT_NEAR(rest_in(unit).first / one.first, 1, 1e-12) << unit;
  }
}

TEST(Equilibrium, GuardSlowsTheWayDownButRestIsTheSame) {
  Cantilever free, guarded;
  guarded.options.guard = {0.5, 50, nullptr};
  const EquilibriumReport one = free.rest();
  const EquilibriumReport other = guarded.rest();
  EXPECT_EQ(other.end, EquilibriumEnd::converged);
  EXPECT_GT(other.work.factorizations, 10);  // the tip moves 10 in parts of about 0.5
  EXPECT_NEAR(other.energy / one.energy, 1, 1e-8);
  EXPECT_LT((free.rod.nodes - guarded.rod.nodes).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(Equilibrium, ARoundEndsWhereItHasGoneAsFarAsTheGuardLetsIt) {
  Cantilever c;
  c.options.guard = {0.5, 50, nullptr};
  const EquilibriumReport report = c.rest();
  EXPECT_EQ(report.end, EquilibriumEnd::converged);
  // a round that bounces off the guard takes all its 35
  EXPECT_LT(report.work.evaluations, 28 * report.work.factorizations);
}

TEST(Equilibrium, RoundsThatAreNotAdmissibleAreTakenBackAndReported) {
  Cantilever c;
  const Points start = c.rod.nodes;
  c.options.guard = {0.5, 50, [](const RodState&, const RodState&) { return false; }};
  const EquilibriumReport report = c.rest();
  EXPECT_EQ(report.end, EquilibriumEnd::inadmissible);
  EXPECT_EQ(report.work.rounds_taken_back, 5);  // at 1, 1/2, ... 1/16 of the distance
  EXPECT_EQ(c.rod.nodes, start);
}

TEST(Equilibrium, RoundsTakenBackCountAgainstTheLimitOfEvaluations) {
  Cantilever c;
  c.options.method.max_evaluations = 10;
  c.options.method.refactor_every = 5;
  c.options.guard = {0.5, 50, [](const RodState&, const RodState&) { return false; }};
  const EquilibriumReport report = c.rest();
  EXPECT_EQ(report.end, EquilibriumEnd::evaluation_limit);
  // NLopt may take one evaluation more in each of the rounds
  EXPECT_LE(report.work.evaluations, 13);
}

TEST(Equilibrium, OneBadRoundIsRepeatedWithShorterMoves) {
  Cantilever c;
  int calls = 0;
  c.options.guard = {0.5, 50, [&](const RodState&, const RodState&) { return ++calls != 3; }};
  const EquilibriumReport report = c.rest();
  EXPECT_EQ(report.end, EquilibriumEnd::converged);
  EXPECT_EQ(report.work.rounds_taken_back, 1);
}

TEST(Equilibrium, a_long_way_takes_fewer_rounds_where_the_guard_lets_snaps_go_farther) {
  const auto rest_with = [](double snap_distance, double longest_admissible) {
    Cantilever c;
    c.options.guard = {0.5, 50, [=](const RodState& before, const RodState& after) {
                         return (after.nodes - before.nodes).colwise().norm().maxCoeff() <
                                longest_admissible;
                       }};
    c.options.guard.snap_distance = snap_distance;
    const EquilibriumReport report = c.rest();
    EXPECT_EQ(report.end, EquilibriumEnd::converged);
    return report;
  };
  const EquilibriumReport steady = rest_with(0, 100), snap = rest_with(4, 100);
  EXPECT_LT(3 * snap.work.factorizations, 2 * steady.work.factorizations);
  EXPECT_NEAR(snap.energy / steady.energy, 1, 1e-8);
  // one round that may not be kept, and no longer ones any more
  const EquilibriumReport hindered = rest_with(4, 0.75);
  EXPECT_EQ(hindered.work.rounds_taken_back, 1);
  EXPECT_EQ(hindered.work.factorizations, steady.work.factorizations + 1);
}

TEST(Equilibrium, TooFewEvaluationsAreReportedWithTheBestPoint) {
  Cantilever c;
  c.options.method.max_evaluations = 5;
  const EquilibriumReport report = c.rest();
  EXPECT_EQ(report.end, EquilibriumEnd::evaluation_limit);
  EXPECT_EQ(report.work.evaluations, 5);
  EXPECT_GT(report.residual, 1);
  EXPECT_LT(report.energy, 0);  // better than the straight start
}

TEST(Equilibrium, NearRestTheHessianSavesEvaluations) {
  const auto evaluations_from_near_rest = [](double exactness) {
    Cantilever c;
    // so strong that the tension along the wire, which squares do not know, holds it as much as
    // bending
    c.load = LoadEnergy(c.params, Loads{{{0, Vec3(0.4, 0, 0)}}, {}, Vec3::Zero()});
    c.rest();
    for (Index i = 0; i < 20; ++i) c.rod.nodes(1, i) += 0.05 * static_cast<double>(20 - i);
    c.options.exactness = exactness;
    const EquilibriumReport report = c.rest();
    EXPECT_EQ(report.end, EquilibriumEnd::converged);
    return report.work.evaluations;
  };
  EXPECT_LT(2 * evaluations_from_near_rest(1), evaluations_from_near_rest(0));
}

TEST(Equilibrium, WhereTheHessianIsNotPositiveTheSquaresServe) {
  Cantilever c;
  for (Index i = 0; i < 20; ++i) c.rod.nodes(2, i) = 0.95 * c.rod.nodes(2, i) + 1;
  c.options.exactness = 1;
  const EquilibriumReport report = c.rest();
  EXPECT_EQ(report.end, EquilibriumEnd::converged);
  EXPECT_NEAR(c.rod.nodes(0, 0) / 20, 0.4984, 0.003);
}

TEST(Equilibrium, StartWithoutAnEnergyIsANumericalFailure) {
  Cantilever c;
  c.rod.nodes(0, 3) = std::nan("");
  EXPECT_THROW(c.rest(), NumericalFailure);
}

}  // namespace
}  // namespace wirepack
