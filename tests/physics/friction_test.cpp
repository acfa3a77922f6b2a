#include <gtest/gtest.h>

#include "wirepack/core/rotation.hpp"
#include "wirepack/packing/quasistatic_packing.hpp"

#include "../support/elastic_rest.hpp"
#include "../support/rubbing_wire.hpp"
#include "../support/strain_of_turn.hpp"

namespace wirepack {
namespace {

using testing::RubbingWire;

constexpr double degree = pi / 180;

// A short straight wire at the bottom of a sphere, its middle at x = y = 0, under its own weight.
RubbingWire wire_at_the_bottom(double cavity_radius, const Vec3& direction,
                               const FrictionParams& friction) {
  RubbingWire wire{RodParams{}, {cavity_radius}, friction, {}};
  Points nodes(3, 5);
  for (Index i = 0; i < 5; ++i) nodes.col(i) = static_cast<double>(i - 2) * direction;
  nodes.row(2).setConstant(-(cavity_radius - 1));
  wire.params.youngs_modulus = 50;
  wire.rod = make_rod(nodes, wire.params);
  wire.loads.weight = Vec3(0, 0, -0.01);
  return wire;
}

void tilt(RubbingWire& wire, double angle) {
  wire.loads.weight = 0.01 * Vec3(std::sin(angle), 0, -std::cos(angle));
}

Vec3 middle(const RubbingWire& wire) { return wire.rod.nodes.rowwise().mean(); }

// Angle of the wall under the middle of the wire, relative to the weight.
double slope(const RubbingWire& wire) {
  const Vec3 m = middle(wire), w = wire.loads.weight;
  return std::atan2(m.cross(w).norm(), m.dot(w));
}

class Incline : public ::testing::TestWithParam<double> {};

TEST_P(Incline, AWireStaysUpToTheSlopeOfItsStaticCoefficientAndSlidesDownToThatOfTheDynamic) {
  const double mu_s = GetParam(), mu_d = 0.9 * mu_s;
  // lies along the slope, so it cannot roll
  RubbingWire wire =
      wire_at_the_bottom(200, Vec3::UnitX(), {FrictionModel::coulomb, mu_s, mu_d, 0.01});
  const HeldUnknowns held = HeldUnknowns::none(wire.rod);
  for (int k = 0; k < 5; ++k) wire.go(held);  // settles
  const double limit = std::atan(mu_s);
  const Vec3 start = middle(wire);
  for (double part = 0.05; part < 0.995; part += 0.05) {
    wire.go(held, [&] { tilt(wire, part * limit); });
  }
  for (int k = 0; k < 20; ++k) wire.go(held, [&] { tilt(wire, 0.99 * limit); });
  // what has stuck gives way by the slip tolerance and does not creep on
  EXPECT_LT((middle(wire) - start).norm(), 0.011);
  EXPECT_LT(wire.dissipated, mu_s * 0.04 * 0.001);  // a thousandth of a under a weight of 0.04
  wire.go(held, [&] { tilt(wire, 1.01 * limit); });
  EXPECT_GT(wire.dissipated, mu_s * 0.04 * 0.05);
  for (int k = 0; k < 4; ++k) wire.go(held);
  EXPECT_NEAR(std::tan(slope(wire)) / mu_d, 1, 0.01);
}
INSTANTIATE_TEST_SUITE_P(Coefficients, Incline, ::testing::Values(0.1, 0.2, 0.3));

TEST(Rolling, ATurningWireClimbsTheWallWithoutSlipUpToTheSlopeOfItsCoefficientAndThenSpins) {
  const double mu = 0.2, radius = 100;
  RubbingWire wire =
      wire_at_the_bottom(radius, Vec3::UnitY(), {FrictionModel::coulomb, mu, mu, 0.005});
  HeldUnknowns held = HeldUnknowns::none(wire.rod);
  for (int k = 0; k < 5; ++k) wire.go(held);
  held.angle.assign(held.angle.size(), true);
  const double limit = std::atan(mu);
  const double weight = 0.01 * 4;
  const double step = 0.1;  // rad; a rolling wire is carried by a (step - sin(step)) too little
  double turned = 0;
  const auto turn = [&] {
    for (Quat& frame : wire.rod.frames) frame = rotation_about(third_axis(frame), step) * frame;
  };
  while (turned + step < 0.95 * limit * (radius - 1)) {
    wire.go(held, turn);
    turned += step;
    EXPECT_NEAR(slope(wire) * (radius - 1), turned, 0.003 * turned + 0.01);
  }
  EXPECT_LT(wire.dissipated, 0.002 * mu * weight * turned);
  for (int k = 0; k < 30; ++k) wire.go(held, turn);
  EXPECT_NEAR(std::tan(slope(wire)) / mu, 1, 0.01);
  EXPECT_GT(wire.dissipated, 0);
}

// A wire pushed along the inside of a great circle through n equal turns is pressed on the wall by
// its own thrust: thrust in / thrust out = [(cos(D/2) + mu sin(D/2)) / (cos(D/2) - mu sin(D/2))]^n.
class Capstan : public ::testing::TestWithParam<double> {};

TEST_P(Capstan, ThrustGrowsByTheDiscreteRatioAndFallsByItWhenTheWireIsDrawnBack) {
  const double mu = GetParam();
  const Index turns = 16;
  const double radius = 500;  // friction acts a off the centreline: a / R more than the formula
  const double angle = pi / static_cast<double>(turns);
  RubbingWire wire{RodParams{}, {radius}, {FrictionModel::coulomb, mu, mu, 0.01}, {}};
  wire.tolerance = 3e-4;
  Points nodes(3, turns + 2);
  for (Index i = 0; i < nodes.cols(); ++i) {
    const double at = angle * static_cast<double>(i);
    nodes.col(i) = (radius - 1) * Vec3(std::cos(at), std::sin(at), 0);
  }
  wire.params.edge_length = (nodes.col(1) - nodes.col(0)).norm();
  wire.rod = make_rod(nodes, wire.params);
  // Stiff, so that it does not buckle off the wall, and bent by nature, so that it presses on
  // nothing.
  wire.params.youngs_modulus = 3e4;
  wire.params.rest_darboux = wire.rod.frames[3].conjugate() *
                             Vec3(0, 0, testing::strain_of_turn(angle) / wire.params.edge_length);
  const Vec3 out = testing::tangent(wire.rod, turns);
  const Vec3 against = testing::tangent(wire.rod, 0);
  wire.loads.forces.push_back({0, Vec3::Zero()});
  HeldUnknowns held = HeldUnknowns::none(wire.rod);
  testing::hold_coordinate(held, 2);
  held.angle.assign(held.angle.size(), true);
  held.hold_node(turns + 1);
  for (double force = 1e-3; force < 1; force *= 1.5) {
    wire.go(held, [&] { wire.loads.forces[0].force = force * against; });
  }
  wire.loads.forces[0].force = against;
  const auto thrust = [&] { return -wire.gradient.node.col(turns + 1).dot(out); };
  const auto push = [&](double way) { wire.rod.nodes.col(turns + 1) -= way * out; };
  const double d = angle / 2;
  const double ratio = std::pow((std::cos(d) + mu * std::sin(d)) / (std::cos(d) - mu * std::sin(d)),
                                static_cast<double>(turns));
  // normal forces follow the thrust from increment to increment
  for (int k = 0; k < 10; ++k) wire.go(held, [&] { push(0.05); });
  EXPECT_NEAR(thrust() / ratio, 1, 0.002);
  for (int k = 0; k < 10; ++k) wire.go(held, [&] { push(-0.05); });
  EXPECT_NEAR(thrust() * ratio, 1, 0.002);
}
INSTANTIATE_TEST_SUITE_P(Coefficients, Capstan, ::testing::Values(0.2, 0.18));

// A straight wire of length L = 2 (R - a), fixed in the nozzle at the near pole, whose tip has
// reached the far one.
constexpr double cavity_radius = 40, span = 2 * (cavity_radius - 1);

struct Peak {
  double force;  // in YI / L^2
  double strain;
};

// Highest force when the wire is fed on from the force `start`.
Peak first_peak(double mu, double start) {
  const Index edges = 96;
  Scenario scenario = default_scenario(Setup::low_torsion, {cavity_radius});
  scenario.wire.stretch_multiplier = 0.2;  // an increment adds 0.3 % to the force
  scenario.minimizer.tolerance = 1e-6;     // a weakly unstable wire is not at rest
  if (mu > 0) scenario.friction = {FrictionModel::coulomb, mu, mu, 0.01};
  const Stiffness stiff = stiffness(scenario.wire);
  const double unit = stiff.bend / (span * span);
  const double length = span / static_cast<double>(edges) / (1 - start * unit / stiff.stretch);
  scenario.wire.edge_length = length;
  scenario.insertion.increment = length / 1000;
  scenario.stop = {};
  scenario.stop.increments = 2000;
  PackingProgress progress;
  Points nodes = Points::Zero(3, edges + 1);
  for (Index i = 0; i <= edges; ++i) {
    nodes(2, i) = 1 - cavity_radius + span * static_cast<double>(i) / static_cast<double>(edges);
  }
  progress.rod = make_rod(nodes, scenario.wire, {.last_clamped = true});
  progress.random_state = 1;
  progress.last.inserted_length = total_rest_length(progress.rod, scenario.wire);
  QuasistaticPacking packing(scenario, progress);
  double peak = 0;
  for (bool going = true; going;) {
    going = !packing.advance().stop;
    const double force = packing.progress().last.force / unit;
    if (force < 0.99 * peak) break;
    peak = std::max(peak, force);
  }
  return {peak, peak * unit / stiff.stretch};
}

// Buckling load in YI / L^2 of the wire whose tip rolls on the wall without slip. The wall pushes
// and holds at the contact, a from the last node: YI w'' = F (c - w) - H (L + a - x) with
// w = w' = 0 in the nozzle, w(L) = c (R - a) / R for a contact moved by c, and w(L) = -a w'(L) for
// a tip that rolls. For a = 0 this is the pinned end, tan kL = kL, with 20.19.
double rolling_load() {
  // how far a solution for F = k^2 YI is from the last two conditions; zero at the load
  const auto determinant = [](double k) {
    const auto unmet = [k](double c, double h) {  // h = H / F
      const double cosine = h * (span + 1) - c, sine = -h / k;
      const double w = c - h + cosine * std::cos(k * span) + sine * std::sin(k * span);
      const double slope = h + k * (sine * std::cos(k * span) - cosine * std::sin(k * span));
      return Eigen::Vector2d(w - c * (cavity_radius - 1) / cavity_radius, w + slope);
    };
    Eigen::Matrix2d matrix;
    matrix << unmet(1, 0), unmet(0, 1);
    return matrix.determinant();
  };
  double low = 4 / span, high = 5 / span;
  EXPECT_LT(determinant(low) * determinant(high), 0);
  while (high - low > 1e-9 / span) {
    const double middle = (low + high) / 2;
    (determinant(low) * determinant(middle) > 0 ? low : high) = middle;
  }
  return std::pow(low * span, 2);
}

// A wire compressed by the strain e bends with YI (1 - e), and the force dE/dL per fed rest length
// is thrust * (1 - e / 2).
double with_compression(double load, const Peak& peak) { return load * (1 - 1.5 * peak.strain); }

// Where the tip slides on the wall, the wall pushes it back to the pole by its curvature:
// tan kL = kL / 2.
TEST(FirstContact, ATipThatSticksRaisesTheFirstPeakFromTheLoadOfASlidingEndToThatOfARollingOne) {
  const double sliding = 18.273763, rolling = rolling_load();
  const double increment = 0.003;
  const Peak slid = first_peak(0, 0.96 * sliding);
  EXPECT_NEAR(slid.force / with_compression(sliding, slid), 1, increment);
  const Peak stuck = first_peak(0.2, 0.96 * sliding);
  EXPECT_NEAR(stuck.force / with_compression(rolling, stuck), 1, increment);
  // hardly any friction is enough to hold the tip while the wire is straight
  const Peak hardly = first_peak(1e-3, 0.96 * sliding);
  EXPECT_GT(hardly.force, 1.05 * slid.force);
  EXPECT_LT(hardly.force, stuck.force);
}

// The highest force of a wire that is fed by these increments from the nozzle on, to a little
// beyond the far pole, over the load at which a wire whose tip rolls buckles.
double first_peak_over_rolling_load(double edge_length, double increment) {
  Scenario scenario = default_scenario(Setup::low_torsion, {cavity_radius});
  scenario.friction = {FrictionModel::coulomb, 0.2, 0.18, 0.02};
  scenario.wire.edge_length = edge_length;
  scenario.insertion.increment = increment;
  scenario.stop = {};
  scenario.stop.length = span + 5;
  QuasistaticPacking packing(scenario);
  const Stiffness stiff = stiffness(scenario.wire);
  const double unit = stiff.bend / (span * span);
  double peak = 0;
  while (!packing.advance().stop) peak = std::max(peak, packing.progress().last.force / unit);
  return peak / with_compression(rolling_load(), {peak, peak * unit / stiff.stretch});
}

// Nothing holds the tip in the increment in which it comes to the wall: it must be held where it
// formed its contact, or the stiff wire throws it off the pole before friction begins.
TEST(FirstContact,
     the_first_peak_of_a_stuck_tip_is_the_rolling_load_for_coarse_and_fine_increments) {
  EXPECT_NEAR(first_peak_over_rolling_load(1, 1), 1, 0.01);
  EXPECT_NEAR(first_peak_over_rolling_load(1, 0.25), 1, 0.01);
  EXPECT_NEAR(first_peak_over_rolling_load(2, 2), 1, 0.01);
}

// A free end presses on the wall with a point of contact.
TEST(FirstContact, the_overlap_of_a_tip_under_a_thrust_is_that_of_a_crossing_on_any_mesh) {
  for (const double edge_length : {2.0, 1.0, 0.5}) {
    RodParams params;
    params.edge_length = edge_length;
    const WallEnergy wall(params, {10}, 5);
    const auto count = static_cast<Index>(8 / edge_length);
    Points nodes = Points::Zero(3, count + 1);
    for (Index i = 0; i <= count; ++i) nodes(2, i) = -9.1 + edge_length * static_cast<double>(i);
    const RodState rod = make_rod(nodes, params, {.last_clamped = true});
    EXPECT_NEAR(wall.forces(rod)[0], 2 * 5 * 0.1, 1e-12) << edge_length;  // 2 a k overlap
  }
}

}  // namespace
}  // namespace wirepack
