#include <algorithm>
#include <functional>
#include <gtest/gtest.h>

#include "wirepack/contact/line_contact.hpp"
#include "wirepack/energy/self_contact_energy.hpp"

#include "../support/sample_rods.hpp"
#include "../support/strands.hpp"

namespace wirepack {
namespace {

using testing::centred_strand;
using testing::helix_strand;
using testing::ring_nodes;
using testing::straight_strand;

constexpr double touching_distance = 2;
constexpr double stiffness = 5;            // k of parallel strands, per length and overlap
constexpr double crossing_stiffness = 10;  // 2 a k of a crossing
constexpr double overlap = 0.1;

LineKernel kernel_of(double edge_length) {
  return LineKernel::per_length(stiffness, touching_distance / 2, edge_length);
}

// Edges of curved strands are not quite parallel, and stiffer by the part of a crossing that they
// are: (k_crossing / k_parallel - 1) times the mean of 1 - cos^8(angle), 4 (l / rho)^2 / 2 for
// rings.
double angle_excess(double edge_length, double radius) {
  const LineKernel kernel = kernel_of(edge_length);
  const double angle = edge_length / radius;
  return (kernel.crossing_stiffness / kernel.parallel_stiffness - 1) * 2 * angle * angle;
}

struct Strand {
  Points nodes;
  bool closed = false;
  bool free_end = false;  // at its first node

  Index edges() const { return closed ? nodes.cols() : nodes.cols() - 1; }
  Line line(Index j) const {
    const Vec3 a = nodes.col(j), b = nodes.col((j + 1) % nodes.cols());
    return {(a + b) / 2, b - a, free_end && j == 0, false};
  }
};

// Energy of two strands and the force on the second.
struct Repulsion {
  double energy = 0;
  Vec3 force = Vec3::Zero();
};
Repulsion repulsion(const LineKernel& kernel, const Strand& first, const Strand& second) {
  Repulsion result;
  for (Index i = 0; i < first.edges(); ++i) {
    for (Index j = 0; j < second.edges(); ++j) {
      LineGradient gradient;
      const double e = kernel.energy(first.line(i), second.line(j), gradient);
      result.energy += e;
      if (e > 0) result.force -= gradient.midpoint2;
    }
  }
  return result;
}

// Range of f over one period.
struct Range {
  double low = HUGE_VAL, high = 0, mean = 0;
  double ripple() const { return (high - low) / mean; }
};
Range range_over(int samples, const std::function<double(double)>& f) {
  Range range;
  for (int k = 0; k < samples; ++k) {
    const double value = f(static_cast<double>(k) / samples);
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
    range.mean += value / samples;
  }
  return range;
}

TEST(StrandContact, CrossedStrandsCarryTheirForceWithTheOverlapAndEnergyOfOneSpring) {
  const Vec3 crossing(0.2, 0, 0);
  const RodState state =
      make_rod(testing::joined_strands(
                   centred_strand(Vec3::Zero(), Vec3::UnitX(), 1, 10),
                   centred_strand(crossing + Vec3(0, 0.3, 2 - overlap), Vec3::UnitY(), 1, 10))
                   .nodes,
               RodParams{});
  SelfContactEnergy energy(RodParams{}, ContactParams{.stiffness = stiffness});
  energy.prepare(state);
  Gradient gradient;
  set_zero(gradient, state);
  const double e = energy.add_gradient(state, gradient);
  const Vec3 on_first = -gradient.node.leftCols(11).rowwise().sum();
  const Vec3 on_second = -gradient.node.rightCols(11).rowwise().sum();
  EXPECT_LT((on_first + on_second).norm(), 1e-12 * on_first.norm());  // rounding
  const double force = on_second.z();
  const double spring = force / overlap;  // F = k overlap
  EXPECT_NEAR(e, force * force / (2 * spring), 1e-12);
  EXPECT_NEAR(spring, crossing_stiffness, 1e-12);
  Vec3 torque = Vec3::Zero(), about_crossing = Vec3::Zero();
  for (Index i = 0; i < state.node_count(); ++i) {
    const Vec3 r = state.nodes.col(i), f = -gradient.node.col(i);
    torque += r.cross(f);
    if (i < 11) about_crossing += (r - crossing).cross(f);
  }
  EXPECT_LT(torque.norm(), 1e-12 * force);          // rounding
  EXPECT_LT(about_crossing.norm(), 1e-12 * force);  // the force acts at the crossing
}

TEST(StrandContact, ACrossingIsOneSpringWhereverOnTheEdgesItFalls) {
  const LineKernel kernel = kernel_of(1);
  for (const double angle : {pi / 2, pi / 3}) {
    const Vec3 direction(std::cos(angle), std::sin(angle), 0);
    const Strand first{centred_strand(Vec3::Zero(), Vec3::UnitX(), 1, 20)};
    Range whole;
    double largest_jump = 0;
    for (double y = 0; y < 1; y += 0.1) {
      double previous = 0;
      const Range along = range_over(101, [&](double x) {
        const Vec3 middle = Vec3(x, 0, 2 - overlap) + y * direction;
        const Repulsion r = repulsion(kernel, first, {centred_strand(middle, direction, 1, 20)});
        const double jump = std::abs(r.force.z() / previous - 1);
        if (previous > 0) largest_jump = std::max(largest_jump, jump);
        previous = r.force.z();
        return r.energy / (crossing_stiffness / 2 * overlap * overlap);
      });
      whole.low = std::min(whole.low, along.low);
      whole.high = std::max(whole.high, along.high);
    }
    // At a right angle the points of the crossing are exact, and the splines sum to one; at pi / 3
    // they are held back by eta = 2^-9 each.
    EXPECT_NEAR(whole.low, 1, angle < 1.5 ? 5e-3 : 1e-12) << angle;
    EXPECT_NEAR(whole.high, 1, angle < 1.5 ? 5e-3 : 1e-12) << angle;
    EXPECT_LT(largest_jump, 1e-3) << angle;  // steps of 1/100 edge, so no jump at nodes
  }
}

// method.md has these numbers: where strands touch along a length, finer edges share more of it.
TEST(StrandContact, strands_that_cross_below_60_degrees_repel_more_on_finer_meshes) {
  const auto force = [](double degrees, double length) {
    const double angle = degrees * pi / 180;
    const Vec3 direction(std::cos(angle), std::sin(angle), 0);
    const auto edges = static_cast<Index>(20 / length);
    const Strand first{centred_strand(Vec3::Zero(), Vec3::UnitX(), length, edges)};
    const Range range = range_over(20, [&](double offset) {
      const Vec3 middle(offset * length, 0, touching_distance - overlap);
      const Strand second{centred_strand(middle, direction, length, edges)};
      return repulsion(kernel_of(length), first, second).force.z();
    });
    return range.mean / (crossing_stiffness * overlap);
  };
  EXPECT_NEAR(force(60, 0.5), 1.01, 0.01);
  EXPECT_NEAR(force(60, 2), 1.00, 0.01);
  EXPECT_NEAR(force(45, 0.5), 1.30, 0.03);
  EXPECT_NEAR(force(45, 2), 1.08, 0.02);
  EXPECT_NEAR(force(30, 0.5), 2.73, 0.05);
  EXPECT_NEAR(force(30, 1), 1.75, 0.05);
  EXPECT_NEAR(force(30, 2), 1.33, 0.05);
}

TEST(StrandContact, ParallelStrandsCarryStiffnessTimesOverlapForAnyMeshAndOffset) {
  for (const double length : {0.5, 1.0, 2.0}) {
    for (const double depth : {0.02, 0.1, 0.4}) {
      const LineKernel kernel = kernel_of(length);
      const Strand edge{centred_strand(Vec3::Zero(), Vec3::UnitX(), length, 1)};
      const Range force = range_over(40, [&](double offset) {
        const Strand other{
            centred_strand(Vec3(offset * length, 0, 2 - depth), Vec3::UnitX(), length, 41)};
        return repulsion(kernel, edge, other).force.z() / length;
      });
      EXPECT_NEAR(force.mean / (stiffness * depth), 1, 1e-6) << length;  // 40 samples of the mean
      // Both points go half-way, so the weights sum to sum B((m + u) / 2)^2: 1.09375 where nodes
      // face midpoints and 1.10547 half-way between.
      EXPECT_NEAR(force.ripple(), (1.10546875 - 1.09375) / 1.1, 1e-6) << length;
    }
  }
}

TEST(StrandContact, StackedRingsSlideOverEachOtherWithoutBumps) {
  const LineKernel kernel = kernel_of(1);
  for (const double radius : {4.0, 8.0}) {
    const auto count = static_cast<Index>(std::round(2 * pi * radius));
    const Strand ring{ring_nodes(radius, count), true};
    const double step = 2 * pi / static_cast<double>(count);
    const Range energy = range_over(40, [&](double offset) {
      const Strand other{ring_nodes(radius, count, 2 - overlap, offset * step), true};
      return repulsion(kernel, ring, other).energy;
    });
    EXPECT_LT(energy.ripple(), 0.0107) << radius;  // that of parallel strands
    const double parallel = stiffness / 2 * overlap * overlap * static_cast<double>(count);
    // the weights of lines at an angle sum up a little higher
    EXPECT_NEAR(energy.mean / parallel, 1 + angle_excess(1, radius), 0.01) << radius;
  }
}

TEST(StrandContact, ConcentricRingsPressOnEachOtherLikeParallelStrands) {
  const double length = 0.5;
  const LineKernel kernel = kernel_of(length);
  for (const double radius : {4.0, 8.0, 16.0, 32.0}) {
    const auto inner_count = static_cast<Index>(std::round(2 * pi * radius / length));
    const double outer_radius = radius + 2 - overlap;
    const auto outer_count = static_cast<Index>(std::round(2 * pi * outer_radius / length));
    const Strand inner{ring_nodes(radius, inner_count), true};
    const Strand outer{ring_nodes(outer_radius, outer_count), true};
    // stiffness per length of both, on average
    const double contact_length = length * static_cast<double>(inner_count + outer_count) / 2;
    const double felt =
        std::sqrt(2 * repulsion(kernel, inner, outer).energy / (stiffness * contact_length));
    // Chords, the angle between edges and the shift of the meeting by it: all of them fall with the
    // square of the curvature. A gap that is off by a 1/40 of the overlap is off by 1/800 a.
    EXPECT_NEAR(felt / overlap, 1, 5e-4 + 0.7 / (radius * radius)) << radius;
    // one outer edge at a time: the contact does not depend on where its nodes are
    const Range ripple = range_over(40, [&](double offset) {
      const double angle = offset * 2 * pi / static_cast<double>(inner_count);
      const Strand edge{ring_nodes(outer_radius, outer_count, 0, angle).leftCols(2)};
      return repulsion(kernel, inner, edge).energy;
    });
    EXPECT_LT(ripple.ripple(), 0.0107 + 0.22 / radius) << radius;
  }
}

TEST(StrandContact, TheForceOnAStrandThatSlidesOffATipFallsSmoothlyToZero) {
  const LineKernel kernel = kernel_of(1);
  const Strand tip{straight_strand(Vec3::Zero(), Vec3::UnitX(), 1, 10), false, true};
  const double h = 0.01;
  double previous = -1, slope = 0, largest_slope = 0, largest_kink = 0, largest_error = 0;
  for (double x = 2; x > -1; x -= h) {
    const auto at = [&](double place) {
      return repulsion(kernel, tip,
                       {centred_strand(Vec3(place, 0.2, 2 - overlap), Vec3::UnitY(), 1, 10)});
    };
    const Repulsion r = at(x);
    const double force = r.force.z();
    if (previous >= 0) {
      const double change = force - previous;
      // where the strands come free, the law of the force itself has a kink
      if (force > 0.05 * crossing_stiffness * overlap) {
        largest_kink = std::max(largest_kink, std::abs(change - slope));
        largest_slope = std::max(largest_slope, std::abs(change));
      }
      slope = change;
      EXPECT_LT(force, previous + 2e-3 * crossing_stiffness * overlap)
          << x;  // falls but for the ripple
    }
    previous = force;
    const double d = 1e-5;
    largest_error = std::max(
        largest_error, std::abs(r.force.x() + (at(x + d).energy - at(x - d).energy) / (2 * d)));
  }
  EXPECT_EQ(previous, 0);  // beyond the tip by more than sqrt(4 - 1.9^2) = 0.62
  // over 1/100 edge the slope changes by a few parts in a hundred; a kink would change all of it
  EXPECT_LT(largest_kink, 0.2 * largest_slope);
  // The force is the derivative, also where the end rule acts. Splines have jumps of the second
  // derivative, so differences over 1e-5 err by as much of k overlap.
  EXPECT_LT(largest_error, 1e-5 * crossing_stiffness * overlap);
  // half-way over the tip's last edge the force is still that of a crossing
  const Repulsion near_tip =
      repulsion(kernel, tip, {centred_strand(Vec3(0.25, 0.2, 2 - overlap), Vec3::UnitY(), 1, 10)});
  EXPECT_NEAR(near_tip.force.z() / (crossing_stiffness * overlap), 1, 0.1);
}

TEST(StrandContact, ATipIsPushedOffAndDoesNotPierceAStrandFromTheSide) {
  const LineKernel kernel = kernel_of(1);
  const Strand side{centred_strand(Vec3(0.3, 0, 0), Vec3::UnitX(), 1, 10)};
  const auto poke = [&](double y, double gap) {
    return repulsion(kernel, side,
                     {straight_strand(Vec3(0, y, gap), Vec3::UnitZ(), 1, 10), false, true});
  };
  EXPECT_EQ(poke(0, 2.001).energy, 0);  // the line through the tip does not reach beyond it
  EXPECT_EQ(poke(0.7, 1.9).energy, 0);  // the tip is 2.02 away
  EXPECT_NEAR(poke(0, 1.9).force.z() / (crossing_stiffness * overlap), 1, 0.1);
  double previous = 0;
  for (double gap = 1.99; gap > 0.5; gap -= 0.02) {
    const double force = poke(0.1, gap).force.z();
    EXPECT_GT(force, previous) << gap;  // ever harder until the tip is at the axis of the strand
    previous = force;
  }
}

// Sum of the forces of all touches of a helix of touching turns, of a whole number of turns.
double helix_force(double turns, double radius, double pitch, double edge_length) {
  const double turn = std::hypot(2 * pi * radius, pitch);
  const auto edges = static_cast<Index>(std::round(turns * turn / edge_length));
  RodParams params;
  params.edge_length = edge_length;
  const RodState state = make_rod(helix_strand(radius, pitch, turns, edges), params);
  SelfContactEnergy energy(params, ContactParams{.stiffness = stiffness});
  energy.prepare(state);
  double force = 0;
  for (const SelfContact& touch : energy.contacts(state)) force += touch.force;
  return force;
}

TEST(StrandContact, TurnsOfACoilPressOnEachOtherWithStiffnessTimesOverlap) {
  const double radius = 8, pitch = 1.9;
  const double turn = std::hypot(2 * pi * radius, pitch);
  const double distance = pitch * 2 * pi * radius / turn;  // of neighbouring turns
  for (const double length : {0.5, 1.0}) {
    // the ends add the same to both, so the difference is that of one turn
    const double per_length =
        (helix_force(4, radius, pitch, length) - helix_force(3, radius, pitch, length)) / turn;
    EXPECT_NEAR(per_length / (stiffness * (2 - distance)), 1 + angle_excess(length, radius), 0.01);
  }
}

TEST(StrandContact, NeighboursAlongTheWireDoNotTouch) {
  // a ring just wider than a touching one, and a half turn as tight as wire can be bent
  RodParams params;
  params.edge_length = 0.25;
  for (const double radius : {1.03, 3.0}) {
    const auto edges = static_cast<Index>(2 * pi * radius / params.edge_length);
    const RodState ring = make_rod(ring_nodes(radius, edges), params, RodEnds{.closed = true});
    SelfContactEnergy energy(params, ContactParams{});
    energy.prepare(ring);
    EXPECT_TRUE(energy.contacts(ring).empty()) << radius;
  }
  // the wider neighbours do: a ring so tight that its opposite sides overlap
  const RodState tight = make_rod(ring_nodes(0.95, 24), params, RodEnds{.closed = true});
  SelfContactEnergy energy(params, ContactParams{.excluded_arc_length = 2.5});
  energy.prepare(tight);
  EXPECT_FALSE(energy.contacts(tight).empty());
}

}  // namespace
}  // namespace wirepack
