#include <gtest/gtest.h>

#include "../support/cantilevers.hpp"
#include "../support/measured_order.hpp"

namespace wirepack {
namespace {

using testing::refine;
using testing::Refinement;

TEST(CantileverConvergence, TipOfTheLoadedCantileverIsOfOrderTwo) {
  const auto& exact = testing::exact_tip_loaded[4];
  const Refinement r = refine([&](Index edges) {
    const testing::Cantilever found = testing::tip_loaded_cantilever(edges, exact.load);
    return std::hypot(found.drop - exact.drop, found.pull_in - exact.pull_in);
  });
  EXPECT_GT(r.order, 1.9);
  EXPECT_LT(r.errors.back(), 2e-5);  // a fraction of (l k)^2 with l k = 0.016
}

// The curvature falls to zero along a boundary layer of a quarter of the length, so the order shows
// from N = 100 on.
TEST(CantileverConvergence, TipAndRootMomentOfTheHeavyCantileverAreOfOrderTwo) {
  const auto& exact = testing::exact_heavy[2];
  const std::vector<Index> counts{100, 200, 400};
  std::vector<double> tip, root;
  for (const Index edges : counts) {
    const testing::Cantilever found = testing::heavy_cantilever(edges, exact.weight);
    tip.push_back(std::hypot(found.drop - exact.drop,
                             1 - found.pull_in - exact.drop / exact.height_by_width));
    root.push_back(std::abs(found.root_curvature / exact.root_curvature - 1));
  }
  EXPECT_GT(testing::measured_order(counts, tip), 1.9);
  EXPECT_GT(testing::measured_order(counts, root), 1.9);
  EXPECT_LT(tip.back(), 1e-5);  // a fraction of (l k)^2 with l k = 0.0094
  EXPECT_LT(root.back(), 1e-5);
}

// The exact values are those of an inextensible rod: with YA = 1e7 the tip goes 0.003 further, so
// this one is stiffened.
TEST(CantileverConvergence, BatheCantileverIsOfOrderTwo) {
  const auto& exact = testing::exact_bathe[2];
  const Refinement r = refine([&](Index edges) {
    return (testing::bathe_tip(edges, exact.force, 1000) - Eigen::Map<const Vec3>(exact.tip.data()))
        .norm();
  });
  EXPECT_GT(r.order, 1.9);
  EXPECT_LT(r.errors.back(), 1.5e-3);  // of an arc of 78.5
}

}  // namespace
}  // namespace wirepack
