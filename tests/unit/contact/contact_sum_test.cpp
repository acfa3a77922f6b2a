#include "wirepack/contact/contact_sum.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "wirepack/core/random.hpp"
#include "wirepack/core/threads.hpp"

#include "../../support/sample_rods.hpp"

namespace wirepack {
namespace {

// A coil, of three turns if not longer, whose strands overlap; both ends touch the turn beside
// them.
RodState tight_coil(const RodParams& params, RodEnds ends = {}, Index count = 80) {
  Random random(5);
  Points nodes(3, count);
  for (Index i = 0; i < nodes.cols(); ++i) {
    const double angle = 0.2 * static_cast<double>(i);
    nodes.col(i) = Vec3(5 * std::cos(angle), 5 * std::sin(angle), 0.29 * angle) +
                   0.05 * Vec3(random.symmetric(), random.symmetric(), random.symmetric());
  }
  return make_rod(nodes, params, ends);
}

struct Sum {
  double energy;
  Points by_node;
};

Sum sum_of(const LineKernel& kernel, const RodState& rod, std::span<const EdgeFour> pairs) {
  Sum sum{0, Points::Zero(3, rod.node_count())};
  sum.energy = add_contact_energy(kernel, rod, pairs, sum.by_node);
  return sum;
}

void expect_sum_over_pairs(const RodState& rod, int least_at_ends) {
  const LineKernel kernel = LineKernel::per_length(5, 1, 1);
  const NeighborList list(rod, {2, 1, pi}, 1);
  const Sum sum = sum_of(kernel, rod, list.fours());
  double energy = 0;
  Points by_node = Points::Zero(3, rod.node_count());
  int touching = 0, at_ends = 0;
  for (const auto& [i, j] : list.pairs()) {
    LineGradient g;
    const double e = kernel.energy(line_of(rod, i), line_of(rod, j), g);
    if (e == 0) continue;
    ++touching;
    if (i == 0 || j == rod.edge_count() - 1) ++at_ends;
    energy += e;
    by_node.col(i) += g.midpoint1 / 2 - g.vector1;
    by_node.col(next_node(rod, i)) += g.midpoint1 / 2 + g.vector1;
    by_node.col(j) += g.midpoint2 / 2 - g.vector2;
    by_node.col(next_node(rod, j)) += g.midpoint2 / 2 + g.vector2;
  }
  EXPECT_GT(touching, 40);
  EXPECT_GE(at_ends, least_at_ends);
  EXPECT_NEAR(sum.energy, energy, 1e-12 * energy);
  EXPECT_LT((sum.by_node - by_node).cwiseAbs().maxCoeff(), 1e-12 * by_node.cwiseAbs().maxCoeff());
}

TEST(ContactSum, FourPairsAtATimeGiveWhatTheKernelGivesForEach) {
  expect_sum_over_pairs(tight_coil(RodParams{}), 2);
}

TEST(ContactSum, OfALongWireIsTheSumOfItsShares) {
  expect_sum_over_pairs(tight_coil(RodParams{}, {}, 2000), 2);
}

TEST(ContactSum, OfAClosedWireCountsTheEdgeThatClosesIt) {
  expect_sum_over_pairs(tight_coil(RodParams{}, {.closed = true}), 2);
}

TEST(ContactSum, CandidatesThatDoNotTouchChangeNoBit) {
  const LineKernel kernel = LineKernel::per_length(5, 1, 1);
  for (const Index nodes : {80, 2000}) {
    const RodState rod = tight_coil(RodParams{}, {}, nodes);
    const Sum wide = sum_of(kernel, rod, NeighborList(rod, {2, 1, pi}, 2).fours());
    const Sum narrow = sum_of(kernel, rod, NeighborList(rod, {2, 1, pi}, 0.1).fours());
    EXPECT_EQ(wide.energy, narrow.energy);
    EXPECT_TRUE((wide.by_node.array() == narrow.by_node.array()).all());
  }
}

TEST(ContactSum, NumberOfThreadsChangesNoBitOfListOrSum) {
  const RodState rod = tight_coil(RodParams{}, {}, 2000);
  const LineKernel kernel = LineKernel::per_length(5, 1, 1);
  std::vector<NeighborList> lists;
  std::vector<Sum> sums;
  for (const int threads : {1, 2, 5}) {
    use_threads(threads);
    lists.emplace_back(rod, ContactRange{2, 1, pi}, 1);
    sums.push_back(sum_of(kernel, rod, lists.back().fours()));
  }
  use_threads(1);
  EXPECT_GT(sums[0].energy, 0);
  for (std::size_t k = 1; k < sums.size(); ++k) {
    EXPECT_TRUE(std::ranges::equal(
        lists[k].fours(), lists[0].fours(), [](const EdgeFour& p, const EdgeFour& q) {
          return p.first == q.first && p.start == q.start && p.listed == q.listed;
        }));
    EXPECT_EQ(sums[k].energy, sums[0].energy);
    EXPECT_TRUE((sums[k].by_node.array() == sums[0].by_node.array()).all());
  }
}

TEST(ContactSum, ListedTouchesAreThoseOfTheKernelAndChangeNoBit) {
  const RodParams params;
  const RodState rod = tight_coil(params);
  const LineKernel kernel = LineKernel::per_length(5, 1, 1);
  const NeighborList list(rod, {2, 1, pi}, 1);
  const Sum plain = sum_of(kernel, rod, list.fours());
  Sum listed{0, Points::Zero(3, rod.node_count())};
  std::vector<SelfContact> touching;
  listed.energy = add_contact_energy(kernel, rod, list.fours(), listed.by_node, touching);
  EXPECT_EQ(listed.energy, plain.energy);
  EXPECT_TRUE((listed.by_node.array() == plain.by_node.array()).all());
  std::size_t expected = 0;
  for (const EdgePair& pair : list.pairs()) {
    const auto touch = kernel.touch(line_of(rod, pair.first), line_of(rod, pair.second));
    if (!touch) continue;
    ++expected;
    const auto same = std::find_if(touching.begin(), touching.end(), [&](const SelfContact& c) {
      return c.edges.first == pair.first && c.edges.second == pair.second;
    });
    ASSERT_NE(same, touching.end());
    EXPECT_NEAR(same->line.s, touch->s, 1e-12);
    EXPECT_NEAR(same->line.t, touch->t, 1e-12);
    EXPECT_NEAR(same->force, touch->stiffness * (2 - touch->distance), 1e-12);
  }
  EXPECT_EQ(touching.size(), expected);
}

}  // namespace
}  // namespace wirepack
