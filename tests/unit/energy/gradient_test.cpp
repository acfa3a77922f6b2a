#include <gtest/gtest.h>

#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/load_energy.hpp"
#include "wirepack/energy/self_contact_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/energy/wall_energy.hpp"

#include "../../support/exact_gradient.hpp"
#include "../../support/sample_rods.hpp"

namespace wirepack {
namespace {

using testing::expect_exact_gradient;
using testing::expect_exact_inlet_derivative;
using testing::random_rod;
using testing::random_vector;
using testing::small_offset;

RodParams curved_params() {
  RodParams params;
  params.rest_darboux = Vec3(0.05, 0.1, -0.07);
  return params;
}

std::vector<RodEnds> all_ends() {
  return {RodEnds{}, RodEnds{.first_clamped = true}, RodEnds{.last_clamped = true},
          RodEnds{.first_clamped = true, .last_clamped = true}};
}

TEST(EnergyGradient, StretchMatchesDifferences) {
  for (const RodEnds& ends : all_ends()) {
    const RodParams params = curved_params();
    StretchEnergy energy(params);
    RodState state = random_rod(12, params, ends, 3);
    state.inlet_rest_length = 0.8;
    expect_exact_gradient(state, energy);
    expect_exact_inlet_derivative(state, energy);
  }
}

TEST(EnergyGradient, of_edges_pressed_below_half_their_length_matches_differences) {
  const RodParams params = curved_params();
  StretchEnergy energy(params);
  RodState state = random_rod(12, params, RodEnds{.last_clamped = true}, 3);
  state.nodes *= 0.4;
  state.inlet_rest_length = 0.8;
  expect_exact_gradient(state, energy);
  expect_exact_inlet_derivative(state, energy);
}

TEST(EnergyGradient, BendAndTwistMatchDifferencesForAllEnds) {
  for (const RodEnds& ends : all_ends()) {
    const RodParams params = curved_params();
    JointEnergy energy(params);
    RodState state = random_rod(12, params, ends, 5);
    state.inlet_rest_length = 1.3;
    expect_exact_gradient(state, energy);
    expect_exact_inlet_derivative(state, energy);
  }
}

TEST(EnergyGradient, BendAndTwistOfAClosedRingMatchDifferences) {
  const RodParams params = curved_params();
  Points nodes(3, 16);
  Random random(11);
  for (Index i = 0; i < 16; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / 16;
    nodes.col(i) =
        Vec3(2.5 * std::cos(angle), 2.5 * std::sin(angle), 0) + 0.1 * random_vector(random);
  }
  RodState state = make_rod(nodes, params, RodEnds{.closed = true});
  state.inlet_rest_length = 1.3;
  JointEnergy joints(params);
  StretchEnergy stretch(params);
  WallEnergy wall(params, {2}, 5);
  for (const EnergyTermRef term :
       {EnergyTermRef(joints), EnergyTermRef(stretch), EnergyTermRef(wall)}) {
    EnergyTerms energy{term};
    expect_exact_gradient(state, energy);
    expect_exact_inlet_derivative(state, energy);
  }
}

TEST(EnergyGradient, WallMatchesDifferences) {
  const RodParams params = curved_params();
  for (const Cavity& cavity : {Cavity{4}, ellipsoid(Vec3(4, 3, 5))}) {
    WallEnergy energy(params, cavity, 5);
    RodState state = random_rod(12, params, {.last_clamped = true}, 5);
    expect_exact_gradient(state, energy);
    state.nodes.colwise() -= state.nodes.col(6);
    expect_exact_inlet_derivative(state, energy);
  }
}

TEST(EnergyGradient, of_the_wall_at_a_free_end_that_leans_matches_differences) {
  const RodParams params = curved_params();
  for (const double lean : {0.0, 0.5, 1.2}) {
    const Cavity cavity = lean != 0.5 ? Cavity{10} : ellipsoid(Vec3(8, 12, 10));
    WallEnergy energy(params, cavity, 5);
    Points nodes(3, 5);
    for (Index i = 0; i < 5; ++i) {
      const auto along = static_cast<double>(i);
      nodes.col(i) = Vec3(0, 0, 9.3) - along * Vec3(std::sin(lean), 0, std::cos(lean));
    }
    const RodState state = make_rod(nodes, params, {.last_clamped = true});
    expect_exact_gradient(state, energy, 0.1 * small_offset(state, 7), 0.1);
  }
}

TEST(EnergyGradient, LoadsMatchDifferences) {
  const RodParams params = curved_params();
  const RodState state = random_rod(12, params, {}, 9);
  Loads loads;
  loads.forces.push_back({3, Vec3(0.3, -0.2, 0.5)});
  loads.moments.push_back(
      {5, Vec3(1, 2, 2) / 3, 0.7, rotation_about(Vec3::UnitX(), 0.4) * state.frames[5]});
  loads.weight = Vec3(0.1, 0, -0.2);
  LoadEnergy energy(params, loads);
  expect_exact_gradient(state, energy);
  expect_exact_inlet_derivative(state, energy);
}

// Two strands side by side or crossing, as the two legs of one long rod.
RodState hairpin(double angle, double shift, double gap) {
  Points nodes(3, 24);
  for (Index i = 0; i < 10; ++i) {
    nodes.col(i) = rotation_about(Vec3::UnitY(), angle) * Vec3(static_cast<double>(i) - 4.5, 0, 0);
    nodes.col(23 - i) = Vec3(static_cast<double>(i) - 4.5 + shift, gap, 0.1 * std::sin(i));
  }
  const Vec3 a = nodes.col(9), b = nodes.col(14);
  for (Index i = 10; i < 14; ++i) {
    const double u = static_cast<double>(i - 9) / 5;
    nodes.col(i) = a + u * (b - a) + std::sin(pi * u) * Vec3(6, 0, 0);
  }
  return make_rod(nodes, RodParams{});
}

TEST(EnergyGradient, SelfContactMatchesDifferencesAtAnyAngleAndAtTheEnds) {
  for (const double angle : {0.0, 0.02, 0.3, 1.5}) {
    for (const double shift : {0.0, 0.3, -0.45}) {
      const RodState state = hairpin(angle, shift, 1.7);
      SelfContactEnergy energy(RodParams{}, ContactParams{});
      SCOPED_TRACE(::testing::Message() << angle << " " << shift);
      expect_exact_gradient(state, energy, 0.2 * small_offset(state, 21), 1e-2);
    }
  }
}

}  // namespace
}  // namespace wirepack
