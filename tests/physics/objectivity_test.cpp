#include <gtest/gtest.h>

#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/self_contact_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"

#include "../support/sample_rods.hpp"

namespace wirepack {
namespace {

using testing::random_rod;
using testing::random_rotation;
using testing::random_vector;

RodParams curved_params() {
  RodParams params;
  params.rest_darboux = Vec3(0.05, 0.1, -0.07);
  return params;
}

// An arch whose legs touch; coordinates are multiples of 2^-30, so that whole numbers up to 2^20
// can be added to them without any rounding.
RodState touching_rod(const RodParams& params, RodEnds ends) {
  Points nodes(3, 30);
  Random random(17);
  for (Index i = 0; i < 30; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / 30;
    const double pinch = 1 - 0.8 * std::pow(std::sin(angle), 2);
    nodes.col(i) =
        Vec3(6 * std::cos(angle), 4.2 * pinch * std::sin(angle), 0) + 0.05 * random_vector(random);
  }
  for (double& v : nodes.reshaped()) v = std::round(v * 0x1p30) * 0x1p-30;
  RodState state = make_rod(nodes, params, ends);
  for (Quat& frame : state.frames) {
    frame = rotation_about(third_axis(frame), 0.3 * random.symmetric()) * frame;
  }
  return state;
}

struct Energies {
  double stretch, bend, twist, contact;
};

Energies energies(const RodParams& params, const RodState& state) {
  Gradient unused;
  set_zero(unused, state);
  SelfContactEnergy contact(params, ContactParams{});
  contact.prepare(state);
  const JointEnergies joints = joint_energies(params, state);
  return {StretchEnergy(params).add_gradient(state, unused), joints.bend, joints.twist,
          contact.add_gradient(state, unused)};
}

void expect_same(const Energies& a, const Energies& b, double relative) {
  EXPECT_NEAR(a.stretch, b.stretch, relative * b.stretch);
  EXPECT_NEAR(a.bend, b.bend, relative * b.bend);
  EXPECT_NEAR(a.twist, b.twist, relative * b.twist);
  EXPECT_NEAR(a.contact, b.contact, relative * b.contact);
}

std::vector<RodEnds> all_ends() {
  return {RodEnds{}, RodEnds{.closed = true}, RodEnds{.first_clamped = true},
          RodEnds{.first_clamped = true, .last_clamped = true}};
}

RodState rotated(const RodState& state, const Quat& rotation) {
  RodState result = state;
  result.nodes = rotation.toRotationMatrix() * state.nodes;
  for (Quat& frame : result.frames) frame = rotation * frame;
  return result;
}

TEST(Objectivity, EveryEnergyIsUnchangedByAnyRotation) {
  Random random(23);
  for (const RodEnds& ends : all_ends()) {
    const RodParams params = curved_params();
    const RodState state = touching_rod(params, ends);
    const Energies before = energies(params, state);
    // nothing passes because it is zero
    for (const double e : {before.stretch, before.bend, before.twist, before.contact}) {
      EXPECT_GT(e, 1e-3);
    }
    for (const double degrees : {1.0, 90.0, 179.0, 200.0, 359.0, 540.0}) {
      const Quat rotation = rotation_about(random_vector(random).normalized(), degrees * pi / 180);
      // 1e-16 of the coordinates over strains of some percent
      expect_same(energies(params, rotated(state, rotation)), before, 1e-12);
    }
  }
}

TEST(Objectivity, EveryEnergyIsUnchangedByAFarTranslation) {
  for (const RodEnds& ends : all_ends()) {
    const RodParams params = curved_params();
    const RodState state = touching_rod(params, ends);
    RodState moved = state;
    moved.nodes.colwise() += Vec3(-30000, 18000, 41000);  // 1000 lengths, exact by construction
    const Energies a = energies(params, moved), b = energies(params, state);
    EXPECT_EQ(a.stretch, b.stretch);
    EXPECT_EQ(a.bend, b.bend);
    EXPECT_EQ(a.twist, b.twist);
    EXPECT_NEAR(a.contact, b.contact, 1e-12 * b.contact);  // works with middles of edges
  }
}

TEST(Objectivity, AFrameAndItsNegativeQuaternionAreTheSameFrame) {
  Random random(29);
  for (const RodEnds& ends : all_ends()) {
    const RodParams params = curved_params();
    const RodState state = touching_rod(params, ends);
    RodState negated = state;
    for (Quat& frame : negated.frames) {
      if (random.symmetric() > 0) frame.coeffs() = -frame.coeffs();
    }
    expect_same(energies(params, negated), energies(params, state), 1e-14);  // signs alone change
  }
}

// Virtual work in a rigid motion: forces on nodes and moments on frames.
void expect_balance(const RodState& state, const Gradient& gradient) {
  const double force_scale = gradient.node.cwiseAbs().sum();
  Vec3 moment = gradient.frame.rowwise().sum();
  double moment_scale = gradient.frame.cwiseAbs().sum();
  for (Index i = 0; i < state.node_count(); ++i) {
    moment += state.nodes.col(i).cross(gradient.node.col(i));
    moment_scale += state.nodes.col(i).norm() * gradient.node.col(i).norm();
  }
  EXPECT_GT(moment_scale, 1e-3);
  EXPECT_LE(gradient.node.rowwise().sum().norm(), 1e-12 * force_scale);  // sums of 30 round-offs
  EXPECT_LE(moment.norm(), 1e-12 * moment_scale);
}

TEST(Objectivity, InternalForcesAndMomentsOfEachTermBalance) {
  for (const RodEnds& ends : all_ends()) {
    const RodParams params = curved_params();
    const RodState state = touching_rod(params, ends);
    Gradient gradient;
    set_zero(gradient, state);
    StretchEnergy(params).add_gradient(state, gradient);
    expect_balance(state, gradient);
    set_zero(gradient, state);
    JointEnergy(params).add_gradient(state, gradient);
    expect_balance(state, gradient);
    set_zero(gradient, state);
    SelfContactEnergy contact(params, ContactParams{});
    contact.prepare(state);
    contact.add_gradient(state, gradient);
    expect_balance(state, gradient);
  }
}

TEST(Objectivity, ForcesOnNodesAndSpinMomentsBalanceInTheUnknowns) {
  for (const RodEnds& ends : {RodEnds{}, RodEnds{.closed = true}}) {
    const RodParams params = curved_params();
    const RodState state = touching_rod(params, ends);
    Gradient gradient;
    set_zero(gradient, state);
    JointEnergy(params).add_gradient(state, gradient);
    const FrameChart chart(state, HeldUnknowns::none(state));
    Eigen::VectorXd by_x;
    chart.pull_back(state, gradient.node, gradient.frame, by_x);
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    for (Index i = 0; i < state.node_count(); ++i) {
      const Vec3 on_node = by_x.segment<3>(chart.unknown(i, 0));
      force += on_node;
      moment += state.nodes.col(i).cross(on_node);
    }
    for (Index j = 0; j < state.edge_count(); ++j) {
      moment += by_x[chart.unknown(j, 3)] * third_axis(state.frames[static_cast<std::size_t>(j)]);
    }
    const double scale = by_x.cwiseAbs().sum();
    EXPECT_GT(scale, 0.1);
    EXPECT_LT(force.norm(), 1e-12 * scale);       // round-off of 30 nodes
    EXPECT_LT(moment.norm(), 1e-12 * 6 * scale);  // lever arms up to 6
  }
}

}  // namespace
}  // namespace wirepack
