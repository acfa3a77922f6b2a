#include "wirepack/contact/neighbor_list.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "wirepack/contact/segment_distance.hpp"
#include "wirepack/energy/self_contact_energy.hpp"

#include "../../support/sample_rods.hpp"
#include "../../support/strands.hpp"

namespace wirepack {
namespace {

using testing::random_vector;

constexpr ContactRange range{.touching_distance = 2, .edge_length = 1, .excluded_arc_length = pi};

bool contains(std::span<const EdgePair> pairs, Index first, Index second) {
  return std::any_of(pairs.begin(), pairs.end(),
                     [&](const EdgePair& p) { return p.first == first && p.second == second; });
}

template <class F>
void for_each_allowed_pair(const RodState& state, Index separation, F&& f) {
  const Index edges = state.edge_count();
  for (Index i = 0; i < edges; ++i) {
    for (Index j = i + separation; j < edges; ++j) {
      if (!state.ends.closed || i + edges - j >= separation) f(i, j);
    }
  }
}

// All pairs whose lines, extended by one edge to both sides, are nearer than this.
std::vector<EdgePair> near_by_brute_force(const RodState& state, double distance) {
  const auto point = [&](Index j, double s) -> Vec3 {
    const Vec3 a = state.nodes.col(j), b = state.nodes.col(next_node(state, j));
    return (a + b) / 2 + s * (b - a);
  };
  std::vector<EdgePair> pairs;
  for_each_allowed_pair(state, first_touching_neighbor(range), [&](Index i, Index j) {
    if (squared_segment_distance(point(i, -1.5), point(i, 1.5), point(j, -1.5), point(j, 1.5)) <
        distance * distance) {
      pairs.push_back({i, j});
    }
  });
  return pairs;
}

// A random walk of unit edges that stays in a ball.
RodState crowd(Index nodes, double radius, RodEnds ends, std::uint64_t seed) {
  Random random(seed);
  Points points(3, nodes);
  Vec3 r = Vec3::Zero(), tangent = Vec3::UnitX();
  for (Index i = 0; i < nodes; ++i) {
    points.col(i) = r;
    tangent = (tangent + random_vector(random) - 0.3 / radius * r).normalized();
    r += tangent;
  }
  return make_rod(points, RodParams{}, ends);
}

TEST(NeighborList, HoldsAllPairsWithinItsMarginForAsLongAsItCoversTheState) {
  for (const auto& [closed, margin] : {std::pair{false, 0.0}, {true, 0.0}, {false, 0.5}}) {
    for (std::uint64_t seed = 1; seed < 6; ++seed) {
      const double skin = 1 + margin;
      const RodState start = crowd(200, 6, {.closed = closed}, seed);
      const NeighborList list(start, range, skin);
      Random random(seed + 100);
      int covered = 0;
      std::size_t touching = 0;
      for (double size : {0.0, 0.05, 0.09, 0.095, 0.2}) {
        RodState moved = start;
        for (auto&& node : moved.nodes.colwise()) node += size * random_vector(random);
        if (!list.covers(moved, margin)) continue;
        ++covered;
        for (const EdgePair& pair : near_by_brute_force(moved, range.touching_distance + margin)) {
          ++touching;
          EXPECT_TRUE(contains(list.pairs(), pair.first, pair.second)) << pair.first;
        }
      }
      EXPECT_GE(covered, 4);      // (skin - margin) / 6 = 0.17 >= 0.095 sqrt(3)
      EXPECT_LE(covered, 4);      // and 0.2 is too far for one of 200 nodes
      EXPECT_GT(touching, 100U);  // the check has something to find
    }
  }
}

TEST(NeighborList, FoursStartAtMultiplesOfFourAndComeSortedEachOnce) {
  const NeighborList list(crowd(200, 6, {}, 4), range, 1);
  std::size_t pairs = 0;
  const EdgeFour* last = nullptr;
  for (const EdgeFour& four : list.fours()) {
    EXPECT_EQ(four.start % 4, 0);
    EXPECT_GT(four.listed, 0U);
    EXPECT_LT(four.listed, 16U);
    if (last != nullptr) {
      EXPECT_TRUE(last->first < four.first ||
                  (last->first == four.first && last->start < four.start));
    }
    last = &four;
    for_each_pair(std::span(&four, 1), [&](const EdgePair& pair) {
      EXPECT_EQ(pair.first, four.first);
      EXPECT_EQ(list.pairs()[pairs++].second, pair.second);
    });
  }
  EXPECT_GT(pairs, 100U);
  EXPECT_EQ(pairs, list.pairs().size());
}

TEST(NeighborList, CoversEveryNodeAndNoOtherNumberOfNodes) {
  RodState state = crowd(50, 6, {}, 9);
  const NeighborList list(state, range, 0.6);
  EXPECT_TRUE(list.covers(state));
  state.nodes.col(49).x() += 0.149;  // the end of its line moves twice as far: 0.15 = skin / 4
  EXPECT_TRUE(list.covers(state));
  state.nodes.col(49).x() += 0.002;
  EXPECT_FALSE(list.covers(state));
  state.nodes.col(49).x() -= 0.002;
  EXPECT_TRUE(list.covers(state, 0.003));  // 0.149 <= (0.6 - 0.003) / 4 = 0.14925
  EXPECT_FALSE(list.covers(state, 0.005));
  EXPECT_FALSE(list.covers(crowd(51, 6, {}, 9)));
  EXPECT_FALSE(NeighborList().covers(state));
}

TEST(NeighborList, OfAContactTermServesAgainWhereAStepIsTakenBack) {
  const RodParams params;
  SelfContactEnergy contact(params, ContactParams{});
  const RodState start = crowd(100, 6, {}, 3);
  RodState far = start;
  far.nodes.col(50).x() += 2;
  EXPECT_TRUE(contact.prepare(start));
  EXPECT_TRUE(contact.prepare(far));
  EXPECT_FALSE(contact.prepare(start));
  EXPECT_FALSE(contact.prepare(far));
}

void expect_all_near_edges(const RodState& state, double reach) {
  const Index separation = 3;
  const std::vector<EdgePair> found = near_edges(state, reach, separation);
  std::vector<EdgePair> expected;
  const auto middle = [&](Index j) -> Vec3 {
    return (state.nodes.col(j) + state.nodes.col(next_node(state, j))) / 2;
  };
  for_each_allowed_pair(state, separation, [&](Index i, Index j) {
    if ((middle(i) - middle(j)).norm() <= reach) expected.push_back({i, j});
  });
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].first, expected[k].first);  // sorted, each once
    EXPECT_EQ(found[k].second, expected[k].second);
  }
}

TEST(NeighborList, NearEdgesAreThoseOfBruteForceInAnyGrid) {
  for (const double reach : {0.5, 1.0, 2.0, 5.0, 100.0}) {
    expect_all_near_edges(crowd(150, 5, {}, 11), reach);
    expect_all_near_edges(crowd(150, 5, {.closed = true}, 12), reach);
    // midpoints on the walls of cells, all in one line, all in one plane
    expect_all_near_edges(make_rod(testing::straight_nodes(20, 20), RodParams{}), reach);
    expect_all_near_edges(
        make_rod(testing::ring_nodes(3, 18), RodParams{}, RodEnds{.closed = true}), reach);
    // one node that has flown off must not cost memory or lose a pair
    RodState stray = crowd(150, 5, {}, 13);
    stray.nodes.col(70) = Vec3(1e6, -1e5, 10);
    expect_all_near_edges(stray, reach);
  }
}

TEST(NeighborList, NeighboursAlongTheWireAreLeftOutByArcLength) {
  for (const auto& [edge_length, first] : {std::pair{2.0, 4}, {1.0, 4}, {0.5, 7}, {0.25, 13}}) {
    EXPECT_EQ(first_touching_neighbor({2, edge_length, pi}), first);
  }
  EXPECT_EQ(first_touching_neighbor({2, 0.5, 3.0}), 6);  // rounding does not make it 7
}

}  // namespace
}  // namespace wirepack
