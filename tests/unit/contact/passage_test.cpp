#include "wirepack/contact/passage.hpp"

#include <gtest/gtest.h>

#include "../../support/sample_rods.hpp"
#include "../../support/strands.hpp"

namespace wirepack {
namespace {

using testing::centred_strand;
using testing::helix_strand;
using testing::joined_strands;
using testing::random_rotation;
using testing::random_vector;

constexpr Index separation = 3;
constexpr Index leg_edges = 10;

// Leg 1 along x at the origin, leg 2 along `direction` above it, shifted by `shift`.
RodState crossed(const Vec3& direction, const Vec3& shift) {
  return make_rod(joined_strands(centred_strand(Vec3::Zero(), Vec3::UnitX(), 1, leg_edges),
                                 centred_strand(shift, direction, 1, leg_edges))
                      .nodes,
                  RodParams{});
}

RodState second_leg_moved(RodState state, const Vec3& move) {
  state.nodes.rightCols(leg_edges + 1).colwise() += move;
  return state;
}

RodState turned(RodState state, const Quat& rotation) {
  for (Vec3 r; auto&& column : state.nodes.colwise()) {
    r = rotation * Vec3(column);
    column = r;
  }
  for (Quat& frame : state.frames) frame = rotation * frame;
  return state;
}

TEST(Passage, AStrandPushedThroughAnotherIsFoundOnceAndAtItsPlace) {
  // crosses edge 6 of leg 1 (x = 1.3) in edge 5 of leg 2 (y = 0.2 from its middle)
  const RodState before = crossed(Vec3::UnitY(), Vec3(1.3, -0.2, 0.6));
  const RodState after = second_leg_moved(before, Vec3(0.1, 0, -1));
  for (const auto& [from, to] : {std::pair{before, after}, std::pair{after, before}}) {
    const auto pairs = passed_pairs(from, to, separation);
    ASSERT_EQ(pairs.size(), 1U);
    EXPECT_EQ(pairs[0].first, 6);
    EXPECT_EQ(pairs[0].second, from.edge_count() - leg_edges + 5);
  }
}

TEST(Passage, AStrandThatComesNearAndTurnsBackIsNotFound) {
  const RodState before = crossed(Vec3::UnitY(), Vec3(1.3, -0.2, 0.6));
  EXPECT_TRUE(passed_pairs(before, before, separation).empty());
  EXPECT_TRUE(
      passed_pairs(before, second_leg_moved(before, Vec3(0, 0, -0.55)), separation).empty());
  // the push that goes through it is real
  EXPECT_FALSE(
      passed_pairs(before, second_leg_moved(before, Vec3(0, 0, -0.65)), separation).empty());
}

TEST(Passage, ALegThatPassesBesideTheEndIsNotFound) {
  const RodState before = crossed(Vec3::UnitY(), Vec3(-5.3, 0, 0.6));
  EXPECT_TRUE(passed_pairs(before, second_leg_moved(before, Vec3(0, 0, -1.2)), separation).empty());
  EXPECT_FALSE(
      passed_pairs(before, second_leg_moved(before, Vec3(0.8, 0, -1.2)), separation).empty());
}

TEST(Passage, AHitOnTwoNodesIsFoundOnce) {
  // centred, so that no common rotation is found and the middle nodes meet exactly
  const RodState before = crossed(Vec3::UnitY(), Vec3(0, 0, 0.6));
  EXPECT_EQ(passed_pairs(before, second_leg_moved(before, Vec3(0, 0, -1)), separation).size(), 1U);
  // a node of the second leg on the inside of an edge
  const RodState beside = crossed(Vec3(0.6, 0.8, 0), Vec3(0, 0, 0.6));
  RodState start = beside;
  start.nodes.leftCols(leg_edges + 1).row(0).array() += 0.3;
  RodState end = second_leg_moved(start, Vec3(0, 0, -1));
  EXPECT_EQ(passed_pairs(start, end, separation).size(), 1U);
}

TEST(Passage, ParallelStrandsThatChangePlacesAreFoundThoughTheyAlwaysShareAPlane) {
  for (const double offset : {0.0, 0.3}) {
    const RodState before = crossed(Vec3::UnitX(), Vec3(offset, 0, 0.6));
    EXPECT_FALSE(
        passed_pairs(before, second_leg_moved(before, Vec3(0, 0, -1)), separation).empty());
    // beside each other, over each other's line, and along each other
    for (const Vec3& move : {Vec3(0.4, 0, -0.3), Vec3(0, 2, -1.8), Vec3(3, 0, 0)}) {
      EXPECT_TRUE(passed_pairs(before, second_leg_moved(before, move), separation).empty());
    }
  }
}

TEST(Passage, CoplanarEdgesThatDoNotMeetAreNotFound) {
  // a flat wire: an arc, and a leg that moves about beside it
  const auto flat = [](const Vec3& shift) {
    Points nodes(3, 30);
    nodes.leftCols(20) = testing::ring_nodes(8, 38).leftCols(20);
    for (Index i = 20; i < 30; ++i)
      nodes.col(i) = Vec3(-9 + 0.7 * static_cast<double>(i - 20), -2, 0);
    nodes.rightCols(8).colwise() += shift;
    return make_rod(nodes, RodParams{});
  };
  const RodState before = flat(Vec3::Zero());
  EXPECT_TRUE(passed_pairs(before, flat(Vec3(0.5, 3, 0)), separation).empty());
  EXPECT_TRUE(passed_pairs(before, flat(Vec3(2, -1.9, 0)), separation).empty());
  EXPECT_FALSE(passed_pairs(before, flat(Vec3(0, 12, 0)), separation).empty());
}

// A dense coil of five layers of helices, each layer back and forth, with a random wobble.
RodState dense_coil(std::uint64_t seed, double wobble) {
  Random random(seed);
  std::vector<Vec3> points;
  for (int layer = 0; layer < 5; ++layer) {
    Points turns = helix_strand(12 - 2 * layer, 2, 8, 400 - 60 * layer);
    if (layer % 2 == 1) turns = turns.rowwise().reverse().eval();
    for (Index i = 0; i < turns.cols(); ++i) points.emplace_back(turns.col(i) - Vec3(0, 0, 8));
  }
  Points nodes(3, static_cast<Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    nodes.col(static_cast<Index>(i)) = points[i] + wobble * random_vector(random);
  }
  return make_rod(nodes, RodParams{});
}

TEST(Passage, ARigidRotationOfADensePackingPassesNothing) {
  const RodState before = dense_coil(3, 0.15);
  const RodState wobbled = dense_coil(4, 0.15);  // nodes within 0.6 of those of `before`
  ASSERT_TRUE(passed_pairs(before, wobbled, separation).empty());
  Random random(5);
  for (const double angle : {0.3, 2.0, 170.0 / 180 * pi}) {
    const Vec3 axis = random_vector(random).normalized();
    const Quat rotation = rotation_about(axis, angle);
    EXPECT_TRUE(passed_pairs(before, turned(before, rotation), separation).empty()) << angle;
    EXPECT_TRUE(passed_pairs(before, turned(wobbled, rotation), separation).empty()) << angle;
  }
}

TEST(Passage, APassageIsFoundInsideATurnedPacking) {
  // a node of the second layer sticks out between two turns of the first and goes over to the next
  // gap, so both its edges go through a turn of the first layer
  const Index node = 500;
  const auto stuck_out = [&](double height) {
    RodState state = dense_coil(3, 0);
    state.nodes.col(node).head<2>() *= 14.0 / 10;
    state.nodes.col(node).z() += height;
    return state;
  };
  const RodState before = stuck_out(3);
  const RodState after = stuck_out(5);
  const auto straight = passed_pairs(before, after, separation);
  ASSERT_EQ(straight.size(), 2U);
  const auto rotated =
      passed_pairs(before, turned(after, rotation_about(Vec3(2, -1, 2) / 3, 2.9)), separation);
  ASSERT_EQ(rotated.size(), straight.size());
  for (std::size_t k = 0; k < straight.size(); ++k) {
    EXPECT_EQ(rotated[k].first, straight[k].first);
    EXPECT_EQ(rotated[k].second, straight[k].second);
    EXPECT_LT(straight[k].first, 400);
    EXPECT_TRUE(straight[k].second == node - 1 || straight[k].second == node);
  }
}

TEST(Passage, SlidingAlongItselfPassesNothingAlsoWhenWireIsAdded) {
  // wire fed along a coil: every node goes to the place the next node had
  const Points places = helix_strand(6, 1.9, 6, 240);
  const RodState before = make_rod(places.rightCols(240), RodParams{});
  const RodState after = make_rod(places, RodParams{});
  EXPECT_TRUE(passed_pairs(before, after, separation).empty());
  EXPECT_TRUE(passed_pairs(after, before, separation).empty());
}

TEST(Passage, AClosedRodIsCheckedAroundItsJoint) {
  Points nodes = testing::ring_nodes(6, 40);
  const RodState before = make_rod(nodes, RodParams{}, RodEnds{.closed = true});
  RodState after = before;
  // the edges of node 20 are pulled over the edge that joins the last node to the first
  after.nodes.col(20) += Vec3(13, -0.5, 0.1);
  RodState start = before;
  start.nodes.col(20) += Vec3(13, -0.5, 3);
  EXPECT_TRUE(passed_pairs(start, after, separation).empty());
  after.nodes.col(20).z() = -3;
  const auto pairs = passed_pairs(start, after, separation);
  ASSERT_EQ(pairs.size(), 2U);  // both edges at node 20 go through the ring
  EXPECT_EQ(pairs[0].second, 39);
  EXPECT_EQ(pairs[1].second, 39);
}

}  // namespace
}  // namespace wirepack
