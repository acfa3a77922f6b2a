#include "wirepack/energy/slip_potential.hpp"

#include <gtest/gtest.h>

#include "wirepack/energy/wall_energy.hpp"
#include "wirepack/solve/gradient_check.hpp"

#include "../../support/sample_rods.hpp"
#include "../../support/strands.hpp"

namespace wirepack {
namespace {

using testing::centred_strand;
using testing::joined_strands;
using testing::random_rotation;
using testing::random_vector;

constexpr double overlap = 0.1;
const FrictionParams friction{FrictionModel::coulomb, 0.3, 0.2, 0.01};

RodState moved(const RodState& state, const Quat& rotation, const Vec3& shift) {
  RodState result = state;
  result.nodes = (rotation.toRotationMatrix() * state.nodes).colwise() + shift;
  for (Quat& frame : result.frames) frame = rotation * frame;
  return result;
}

// Two straight legs of one wire that cross at this angle, touching; the second lies below.
RodState two_legs(double angle, RodEnds ends = {}) {
  const Vec3 along(std::cos(angle), std::sin(angle), 0);
  const Points first = centred_strand(Vec3::Zero(), Vec3::UnitX(), 1, 10);
  const Points second = centred_strand(Vec3(0.2, 0, overlap - 2), along, 1, 10);
  return make_rod(joined_strands(first, second).nodes, RodParams{}, ends);
}

bool lies_below(const RodState& rod, Index node) { return rod.nodes(2, node) < -1; }

void move_lower_leg(RodState& rod, double way) {
  for (Index i = 0; i < rod.node_count(); ++i) {
    if (lies_below(rod, i)) rod.nodes(0, i) += way;
  }
}

double force_on_lower_leg(const RodState& rod, const Gradient& gradient) {
  double sum = 0;
  for (Index i = 0; i < rod.node_count(); ++i) {
    if (lies_below(rod, i)) sum += gradient.node(0, i);
  }
  return sum;
}

void spin(RodState& rod, bool lower, double angle) {
  for (Index j = 0; j < rod.edge_count(); ++j) {
    if (lies_below(rod, j + 1) != lower) continue;
    Quat& frame = rod.frames[static_cast<std::size_t>(j)];
    frame = rotation_about(third_axis(frame), angle) * frame;
  }
}

struct Touching {
  RodState rod;
  std::vector<SelfContact> touches;
  Eigen::VectorXd no_wall;

  explicit Touching(const RodState& state, double tilt = 1e-12)
      : rod(state), no_wall(Eigen::VectorXd::Zero(state.node_count())) {
    SelfContactEnergy contact(RodParams{}, ContactParams{});
    contact.prepare(rod);
    // those of the legs, not of the bridge between them
    for (const SelfContact& touch : contact.contacts(rod)) {
      const bool between_legs = lies_below(rod, touch.edges.second) &&
                                lies_below(rod, touch.edges.second + 1) &&
                                touch.line.separation.z() > touch.line.distance - tilt;
      if (between_legs) touches.push_back(touch);
    }
  }
  double normal_force() const {
    double sum = 0;
    for (const SelfContact& touch : touches) sum += touch.force;
    return sum;
  }
  SlipPotential potential(std::span<const SlipMemory> memory = {}) const {
    SlipPotential slip(RodParams{}, Cavity{}, friction);
    slip.start(rod, touches, no_wall, memory);
    return slip;
  }
};

double value(const SlipPotential& potential, const RodState& state) {
  Gradient unused;
  set_zero(unused, state);
  return potential.add_gradient(state, unused);
}

// Memory of contacts of which some have slid, with springs in all directions.
std::vector<SlipMemory> some_memory(const Touching& touching) {
  Random random(5);
  std::vector<SlipMemory> memory;
  for (const SelfContact& touch : touching.touches) {
    memory.push_back({touch.edges, 0.01 * random_vector(random), random.symmetric()});
  }
  for (Index i = 0; i < touching.rod.node_count(); ++i) {
    memory.push_back({{i, -1}, 0.01 * random_vector(random), random.symmetric()});
  }
  std::sort(memory.begin(), memory.end(),
            [](const auto& a, const auto& b) { return a.edges.first < b.edges.first; });
  return memory;
}

// Steps that leave some contacts stuck and let others slide by up to a wire radius.
TEST(SlipPotential, GradientMatchesDifferencesForStuckAndSlidingContacts) {
  for (const RodEnds& ends : {RodEnds{}, RodEnds{.last_clamped = true}}) {
    for (const double angle : {0.0, 0.4, 1.5}) {
      Touching touching(two_legs(angle, ends), 0.01);
      RodState& rod = touching.rod;
      const double reach = rod.nodes.colwise().norm().maxCoeff() + 0.5;
      const Cavity cavity = angle == 0.4 ? ellipsoid(reach * Vec3(1, 0.9, 1.1)) : Cavity{reach};
      touching.no_wall = WallEnergy(RodParams{}, cavity, 5).forces(rod);
      SlipPotential potential = touching.potential(some_memory(touching));
      const FrameChart chart(rod, HeldUnknowns::none(rod));
      Random random(11);
      for (const double step : {0.004, 0.3}) {
        Eigen::VectorXd offset(chart.size());
        for (double& v : offset) v = step * random.symmetric();
        const GradientCheck check =
            check_gradient(rod, HeldUnknowns::none(rod), EnergyTerms{potential}, offset, 1e-7);
        EXPECT_GT(check.largest_derivative, 0.05);
        // central differences over 1e-7: rounding 1e-16 / 1e-7, and kinks of the second derivative
        EXPECT_LT(check.relative_error, 1e-6) << angle << " " << step;
      }
    }
  }
}

TEST(SlipPotential, DerivativeByTheFedLengthMatchesDifferences) {
  // the last edges of the second leg touch the first: the inlet edge among them
  const Points first = centred_strand(Vec3::Zero(), Vec3::UnitX(), 1, 10);
  const Points second = centred_strand(Vec3(0, 4.6, overlap - 2), -Vec3::UnitY(), 1, 10);
  const Touching touching(
      make_rod(joined_strands(first, second).nodes, RodParams{}, {.last_clamped = true}), 0.01);
  SlipPotential potential = touching.potential();
  RodState fed = touching.rod;
  for (const double length : {1.001, 1.3}) {  // stuck, sliding
    fed.inlet_rest_length = length;
    const GradientCheck check = check_inlet_derivative(fed, EnergyTerms{potential}, 1e-6);
    EXPECT_GT(check.largest_derivative, 1e-3);
    EXPECT_LT(check.relative_error, 1e-7) << length;
  }
}

TEST(SlipPotential, ARigidMotionOfAnySizeMakesNoSlip) {
  Random random(7);
  for (const double angle : {0.0, 0.4, 1.5}) {
    const Touching touching(two_legs(angle), 0.01);
    ASSERT_FALSE(touching.touches.empty());
    const SlipPotential unstretched = touching.potential();
    const SlipPotential stretched = touching.potential(some_memory(touching));
    const double before = value(stretched, touching.rod);
    EXPECT_GT(before, 1e-5);
    for (int k = 0; k < 5; ++k) {
      const RodState rod = moved(touching.rod, random_rotation(random), 10 * random_vector(random));
      // round-off of coordinates of 20: |u| = 1e-14
      EXPECT_LT(value(unstretched, rod), 1e-24);
      EXPECT_NEAR(value(stretched, rod) / before, 1, 1e-11);
    }
  }
}

TEST(SlipPotential, StuckAndSlidingContactsCarryNoForceAndNoMomentTogether) {
  Random random(9);
  const Touching touching(two_legs(0.4), 0.01);
  const SlipPotential potential = touching.potential(some_memory(touching));
  RodState rod = touching.rod;
  rod.nodes += 0.2 * Points::Random(3, rod.node_count());
  carry_frames(rod);
  Gradient gradient;
  set_zero(gradient, rod);
  potential.add_gradient(rod, gradient);
  Vec3 about_origin = gradient.frame.rowwise().sum();
  for (Index i = 0; i < rod.node_count(); ++i) {
    about_origin += Vec3(rod.nodes.col(i)).cross(Vec3(gradient.node.col(i)));
  }
  EXPECT_GT(gradient.node.colwise().norm().maxCoeff(), 0.01);
  EXPECT_LT(gradient.node.rowwise().sum().norm(), 1e-14);
  EXPECT_LT(about_origin.norm(), 1e-13);
}

TEST(SlipPotential, AStrandPulledAlongAnotherIsHeldByTheStaticCoefficientTimesTheNormalForce) {
  const Touching touching(two_legs(0));
  const SlipPotential potential = touching.potential();
  const double held = friction.static_coefficient * touching.normal_force();
  RodState rod = touching.rod;
  for (const double way : {0.002, 0.5}) {
    rod.nodes = touching.rod.nodes;
    move_lower_leg(rod, way);
    Gradient gradient;
    set_zero(gradient, rod);
    const double energy = potential.add_gradient(rod, gradient);
    const double part = way < 0.01 ? way / 0.01 : 1;
    EXPECT_NEAR(force_on_lower_leg(rod, gradient) / (part * held), 1, 1e-10);
    EXPECT_NEAR(energy / (held * (way < 0.01 ? way * way / 0.02 : way - 0.005)), 1, 1e-10);
    const SlipWork work = potential.work(rod);
    EXPECT_NEAR(work.dissipated, way < 0.01 ? 0 : held * (way - 0.01), 1e-10 * held);
    EXPECT_NEAR(work.dissipated + work.stored, energy, 1e-12 * energy);
  }
}

TEST(SlipPotential, AStrandThatSpinsInPlaceRubsOnTheOtherOverTheArcOfItsSurface) {
  const Touching touching(two_legs(0));
  const SlipPotential potential = touching.potential();
  const double held = friction.static_coefficient * touching.normal_force();
  const double h = (2 - overlap) / 2;  // from the centreline to the surface between both
  RodState rod = touching.rod;
  const double angle = 0.4;
  spin(rod, true, angle);
  // the chord of the arc, 2 h sin(angle / 2)
  EXPECT_NEAR(value(potential, rod) / (held * (2 * h * std::sin(angle / 2) - 0.005)), 1, 1e-10);
  // both spin against each other like cog-wheels: the surfaces roll
  spin(rod, false, -angle);
  EXPECT_LT(value(potential, rod), 1e-20);
}

TEST(SlipPotential, AWireRollsOnTheWallFreelyAndSkidsOnItForMuN) {
  Points nodes(3, 3);
  nodes << -1, 0, 1, 0, 0, 0, -9, -9, -9;  // along x, on the bottom of a cavity
  const RodParams params;
  const RodState rod = make_rod(nodes, params);
  SlipPotential potential(params, Cavity{}, friction);
  Eigen::VectorXd forces(3);
  forces << 0, 2, 0;
  potential.start(rod, {}, forces, {});
  const double angle = 0.2;
  RodState rolled = rod;
  rolled.nodes.row(1).array() += angle;
  const double skids = value(potential, rolled);
  EXPECT_NEAR(skids, 0.3 * 2 * (angle - 0.005), 1e-12);
  for (Quat& frame : rolled.frames) frame = rotation_about(Vec3::UnitX(), -angle) * frame;
  // what is left is a (angle - sin(angle)) = angle^3 / 6, below the slip tolerance
  const double slip = angle - std::sin(angle);
  EXPECT_NEAR(value(potential, rolled), 0.3 * 2 * slip * slip / 0.02, 1e-12);
}

TEST(SlipPotential, WhatRestsKeepsItsSpringAndWhatSlidIsHeldByTheDynamicCoefficient) {
  const Touching touching(two_legs(0));
  const double n = touching.normal_force();
  const auto pull = [&](const RodState& from, double way, std::vector<SlipMemory>& memory) {
    SlipPotential potential(RodParams{}, Cavity{}, friction);
    // contacts and forces of the first state: what is handed on is at issue
    potential.start(from, touching.touches, touching.no_wall, memory);
    RodState rod = from;
    move_lower_leg(rod, way);
    Gradient gradient;
    set_zero(gradient, rod);
    potential.add_gradient(rod, gradient);
    memory = potential.memory(rod);
    return force_on_lower_leg(rod, gradient) / n;
  };
  std::vector<SlipMemory> memory;
  double force = 0;
  for (int k = 1; k <= 4; ++k) {  // in four parts as in one: no creep
    force = pull(touching.rod, 0.002, memory);
    EXPECT_NEAR(force, 0.3 * 0.2 * k, 1e-4 * force);  // springs tilt with the normal: (xi / 2 a)^2
  }
  EXPECT_NEAR(pull(touching.rod, 0.1, memory), 0.3, 1e-5);     // breaks away
  EXPECT_NEAR(pull(touching.rod, 0.1, memory), 0.2, 1e-5);     // slides on
  EXPECT_NEAR(pull(touching.rod, 0, memory), 0.2, 1e-5);       // stops, and keeps the force
  EXPECT_NEAR(pull(touching.rod, 0.002, memory), 0.26, 1e-4);  // rests: up to the static one again
}

// The lower leg comes up by four overlaps, of which the last one presses, while it moves sideways:
// of that way a quarter is against friction.
TEST(SlipPotential, AContactThatFormsOnTheWayIsHeldFromWhereItTouchesOn) {
  const Touching now(two_legs(pi / 2));
  const auto from = [&](double way) {
    RodState rod = now.rod;
    for (Index i = 0; i < rod.node_count(); ++i) {
      if (lies_below(rod, i)) rod.nodes.col(i) -= Vec3(way, 0, 4 * overlap);
    }
    return rod;
  };
  const double n = now.normal_force();
  const auto held_after = [&](double way) {
    SlipPotential potential(RodParams{}, Cavity{}, friction);
    const RodState before = from(way);
    potential.start(before, {}, now.no_wall, {});
    EXPECT_EQ(potential.join(before, now.rod, now.touches, now.no_wall, 10).count,
              static_cast<Index>(now.touches.size()));
    EXPECT_EQ(potential.join(before, now.rod, now.touches, now.no_wall, 10).count, 0);  // once
    Gradient gradient;
    set_zero(gradient, now.rod);
    potential.add_gradient(now.rod, gradient);
    return force_on_lower_leg(now.rod, gradient) / n;
  };
  // a quarter of 0.02 is half the slip tolerance, of which the approach along the tilted normal is
  // a part
  EXPECT_NEAR(held_after(0.02), 0.3 * 0.5 * (1 - overlap / 2), 1e-4);
  EXPECT_NEAR(held_after(0.4), 0.3, 1e-2);
}

TEST(SlipPotential, AContactHandedOnToNeighbouringEdgesIsNotANewOne) {
  const Touching touching(two_legs(0));
  SlipPotential potential = touching.potential();
  std::vector<SelfContact> handed_on = touching.touches;
  for (SelfContact& touch : handed_on) ++touch.edges.second;
  EXPECT_EQ(potential.join(touching.rod, touching.rod, handed_on, touching.no_wall, 10).count, 0);
}

TEST(SlipPotential, ANodeThatComesToTheWallIsHeldThereFromThenOn) {
  const RodState rod = [] {
    Points nodes(3, 3);
    nodes << -1, 0, 1, 9.1, 9.1, 9.1, 0, 0, 0;
    return make_rod(nodes, RodParams{});
  }();
  RodState before = rod;
  before.nodes.row(1).array() -= 0.2;  // its gap was 0.1 there, and is -0.1
  before.nodes.row(2).array() -= 0.02;
  SlipPotential potential(RodParams{}, Cavity{10}, friction);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(3), middle = Eigen::VectorXd::Unit(3, 1);
  potential.start(before, {}, none, {});
  EXPECT_EQ(potential.join(before, rod, {}, middle, 10).count, 1);
  Gradient gradient;
  set_zero(gradient, rod);
  potential.add_gradient(rod, gradient);
  // half the way of 0.02, which is the slip tolerance: on the verge of sliding
  EXPECT_NEAR(gradient.node(2, 1), 0.3, 3e-3);
}

}  // namespace
}  // namespace wirepack
