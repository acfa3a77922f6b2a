#include <gtest/gtest.h>

#include "../support/stability.hpp"

namespace wirepack {
namespace {

using testing::End;
using testing::euler_load;

// A rod this soft shortens by 2.5 % before it buckles, which P (1 - P / YA) must account for
// exactly.
constexpr double stretch = 400;

double reduced(double load) { return load * (1 - load / stretch); }

TEST(EulerLoad, AgreesWithTheTextbookForEveryPairOfEnds) {
  struct Case {
    End first, last;
    double load;
  };
  constexpr Index edges = 100;
  for (const Case& c :
       {Case{End::clamped, End::free, 2.467401}, Case{End::pinned, End::pinned, 9.869604},
        Case{End::clamped, End::pinned, 20.190729}, Case{End::pinned, End::clamped, 20.190729},
        Case{End::clamped, End::clamped, 39.478418}}) {
    const double found = reduced(euler_load(edges, c.first, c.last, 1.05 * c.load, stretch));
    // a chain is too soft by P / (12 N^2) for its curvature; the clamps add a fifth to that
    EXPECT_NEAR(found / c.load, 1, 1.5 * c.load / (12.0 * edges * edges)) << c.load;
  }
}

TEST(EulerLoad, OfThePinnedChainIsExact) {
  struct Chain {
    Index edges;
    double load;  // 4 N^2 sin^2(pi / 2 N)
  };
  for (const Chain& chain : {Chain{10, 9.788696741}, Chain{20, 9.849327524}, Chain{40, 9.864532054},
                             Chain{80, 9.868336119}, Chain{160, 9.869287318}}) {
    const auto n = static_cast<double>(chain.edges);
    const double exact = std::pow(2 * n * std::sin(pi / (2 * n)), 2);
    EXPECT_NEAR(exact, chain.load, 1e-9);  // printed digits
    const double found = reduced(euler_load(chain.edges, End::pinned, End::pinned, 10, stretch));
    // strains of 1e-5 from coordinates rounded to 1e-16 leave 1e-10
    EXPECT_NEAR(found, exact, 1e-9) << chain.edges;
  }
}

TEST(EulerLoad, OfAChainWithItsFirstEdgeHeldIsThatOfHalfAnEdgeMore) {
  struct Chain {
    Index free_edges;
    double load;  // P (N l)^2 / YI; with (N + 1/2) l it tends to 20.190729 with order 2
  };
  for (const Chain& chain : {Chain{20, 19.148577}, Chain{40, 19.677072}, Chain{80, 19.936026}}) {
    const Index edges = chain.free_edges + 1;
    const double share = static_cast<double>(chain.free_edges) / static_cast<double>(edges);
    const double load = testing::root_near(
        [&](double p) {
          testing::Column column =
              testing::compressed_column(edges, End::pinned, End::pinned, p, stretch);
          column.held.hold_node(1);
          return testing::lowest_stiffness(column);
        },
        20, 21);
    EXPECT_NEAR(reduced(load) * share * share, chain.load, 1e-6);  // printed digits
  }
}

TEST(EulerLoad, BendingStiffnessOfACircularSectionIsAQuarterOfPiAToTheFourth) {
  RodParams params;
  params.radius = 0.7;
  params.youngs_modulus = 3;
  EXPECT_NEAR(stiffness(params).bend, 3 * pi * std::pow(0.7, 4) / 4, 1e-15);
}

}  // namespace
}  // namespace wirepack
