#include <gtest/gtest.h>

#include "../support/cantilevers.hpp"

namespace wirepack {
namespace {

using testing::Cantilever;

TEST(Cantilever, UnderATipLoadFollowsBisshoppAndDrucker) {
  for (const testing::TipLoaded& exact : testing::exact_tip_loaded) {
    const Cantilever found = testing::tip_loaded_cantilever(100, exact.load);
    // order 2: where curvature changes by k' along the wire, by (l k')^2 / 12 of k^2
    EXPECT_NEAR(found.tip_degrees / exact.tip_degrees, 1, 1e-4) << exact.load;
    EXPECT_NEAR(found.drop / exact.drop, 1, 1e-4) << exact.load;
    EXPECT_NEAR(found.pull_in / exact.pull_in, 1, 1e-4) << exact.load;
  }
}

TEST(Cantilever, UnderItsOwnWeightFollowsTheMasterCurve) {
  for (const testing::Heavy& exact : testing::exact_heavy) {
    const Cantilever found = testing::heavy_cantilever(200, exact.weight);
    // curvature decays over about 1 / k from the root, errors are a fraction of (l k)^2; the chain
    // has errors of 1 / N^2 also when it is straight; 1e-5: the digits of the table
    const double tolerance = (std::pow(exact.root_curvature, 2) / 40 + 1) / (200.0 * 200) + 1e-5;
    EXPECT_NEAR(found.height_by_width / exact.height_by_width, 1, tolerance) << exact.weight;
    EXPECT_NEAR(found.drop / exact.drop, 1, tolerance) << exact.weight;
    EXPECT_NEAR(found.root_curvature / exact.root_curvature, 1, tolerance) << exact.weight;
  }
}

TEST(Cantilever, UnderASmallWeightDropsByAnEighth) {
  constexpr double weight = 1e-3;
  const Cantilever found = testing::heavy_cantilever(100, weight);
  EXPECT_NEAR(found.drop / weight, 1.0 / 8, 1e-4);  // half weights at the ends: order 2
}

}  // namespace
}  // namespace wirepack
