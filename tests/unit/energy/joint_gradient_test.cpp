#include <gtest/gtest.h>

#include "wirepack/energy/joint_energy.hpp"

#include "../../support/exact_gradient.hpp"
#include "../../support/sample_rods.hpp"

namespace wirepack {
namespace {

using testing::random_rod;
using testing::random_rotation;
using testing::random_vector;

// Both energies come from one term; a Poisson ratio far outside the physical range leaves one.
constexpr double only_bend = 1e12;           // GJ = YI / (1 + nu) vanishes
constexpr double only_twist = -1 + 0x1p-40;  // YI = GJ (1 + nu) vanishes
constexpr double share = 1e-9;               // of the other energy that may be left

RodParams curved_params(double poisson_ratio) {
  RodParams params;
  params.poisson_ratio = poisson_ratio;
  params.youngs_modulus = poisson_ratio < 0 ? 0x1p-38 : 5;
  params.rest_darboux = Vec3(0.05, 0.1, -0.07);
  return params;
}

RodState random_ring(const RodParams& params, std::uint64_t seed) {
  Points nodes(3, 16);
  Random random(seed);
  for (Index i = 0; i < 16; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / 16;
    nodes.col(i) =
        Vec3(2.5 * std::cos(angle), 2.5 * std::sin(angle), 0) + 0.3 * random_vector(random);
  }
  RodState state = make_rod(nodes, params, {.closed = true});
  for (Quat& frame : state.frames) {
    frame = rotation_about(third_axis(frame), pi * random.symmetric()) * frame;
  }
  return state;
}

// Frames of any spin and clamps that stand at any angle of up to a radian to their edges.
RodState random_state(const RodParams& params, const RodEnds& ends, std::uint64_t seed) {
  if (ends.closed) return random_ring(params, seed);
  RodState state = random_rod(14, params, ends, seed);
  Random random(seed + 100);
  for (std::size_t j = 0; j < state.frames.size(); ++j) {
    const bool clamp = static_cast<Index>(j) >= state.edge_count();
    const Vec3 axis = clamp ? random_vector(random).normalized() : third_axis(state.frames[j]);
    state.frames[j] = rotation_about(axis, random.symmetric()) * state.frames[j];
  }
  return state;
}

void expect_exact_gradients(double poisson_ratio, bool bend) {
  const RodParams params = curved_params(poisson_ratio);
  JointEnergy energy(params);
  for (const RodEnds& ends :
       {RodEnds{}, RodEnds{.closed = true}, RodEnds{.first_clamped = true},
        RodEnds{.last_clamped = true}, RodEnds{.first_clamped = true, .last_clamped = true}}) {
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
      const RodState state = random_state(params, ends, seed);
      const JointEnergies parts = joint_energies(params, state);
      EXPECT_LT(bend ? parts.twist : parts.bend, share * (bend ? parts.bend : parts.twist));
      testing::expect_exact_gradient(state, energy, testing::small_offset(state, seed), 0.1);
    }
  }
}

TEST(JointGradient, OfBendingAloneMatchesDifferencesForAllEnds) {
  expect_exact_gradients(only_bend, true);
}

TEST(JointGradient, OfTwistAloneMatchesDifferencesForAllEnds) {
  expect_exact_gradients(only_twist, false);
}

TEST(JointGradient, OfWholeTurnsOfTwistMatchesDifferences) {
  const RodParams params = curved_params(1.0 / 3);
  JointEnergy energy(params);
  RodState state = random_state(params, {.last_clamped = true}, 3);
  // the same frames, but with up to two turns of twist either way in a joint
  for (std::size_t i = 1; i < state.twist_guide.size(); ++i) {
    state.twist_guide[i] += 2 * pi * (static_cast<double>(i % 5) - 2);
  }
  const HeldUnknowns none = HeldUnknowns::none(state);
  const Eigen::VectorXd offset = Eigen::VectorXd::Zero(FrameChart(state, none).size());
  const GradientCheck check = check_gradient(state, none, EnergyTerms{energy}, offset, 1e-5);
  EXPECT_GT(check.largest_derivative, 30);  // GJ 4 pi / l = 37
  EXPECT_LT(check.relative_error, 1e-7);    // rounding 1e-16 1000 over 1e-5 and 30, and 1e-10
}

TEST(JointGradient, OfTangentsAloneIsThatOfFramesWithoutTwist) {
  const RodParams params;
  Stiffness no_twist = stiffness(params);
  no_twist.twist = 0;
  Stiffness hardly_any = no_twist;
  hardly_any.twist = 1e-200;  // frames are read, and their twist costs nothing
  const JointEnergy of_tangents(params, no_twist), of_frames(params, hardly_any);
  for (const RodEnds& ends :
       {RodEnds{}, RodEnds{.closed = true}, RodEnds{.first_clamped = true, .last_clamped = true}}) {
    RodState state = random_state(params, ends, 7);
    state.inlet_rest_length = 1.3;
    const FrameChart chart(state, HeldUnknowns::none(state));
    Gradient by_tangents, by_frames;
    set_zero(by_tangents, state);
    set_zero(by_frames, state);
    const double energy = of_tangents.add_gradient(state, by_tangents);
    EXPECT_GT(energy, 0.1);
    EXPECT_NEAR(of_frames.add_gradient(state, by_frames), energy, 1e-13 * energy);
    EXPECT_NEAR(by_tangents.inlet_length, by_frames.inlet_length, 1e-13 * energy);
    EXPECT_NE(by_tangents.inlet_length, 0);
    Eigen::VectorXd x_tangents, x_frames;
    chart.pull_back(state, by_tangents.node, by_tangents.frame, x_tangents);
    chart.pull_back(state, by_frames.node, by_frames.frame, x_frames);
    const double largest = x_frames.cwiseAbs().maxCoeff();
    EXPECT_GT(largest, 0.1);
    EXPECT_LT((x_tangents - x_frames).cwiseAbs().maxCoeff(), 1e-12 * largest);
    // a clamp's spin is no unknown of the chart, but its moment is part of the gradient
    const Index clamps = static_cast<Index>(state.frames.size()) - state.edge_count();
    EXPECT_LT((by_tangents.frame.rightCols(clamps) - by_frames.frame.rightCols(clamps)).norm(),
              1e-12 * largest);
  }
}

}  // namespace
}  // namespace wirepack
