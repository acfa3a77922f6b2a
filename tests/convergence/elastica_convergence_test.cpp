#include <gtest/gtest.h>

#include "../support/elastica.hpp"
#include "../support/measured_order.hpp"

namespace wirepack {
namespace {

using testing::refine;
using testing::Refinement;

using testing::ElasticaShape;

void expect_order_two(double shortening, bool clamped) {
  const ElasticaShape exact = testing::elastica_of_shortening(shortening);
  const double factor = clamped ? 4 : 1;
  const std::vector<Index> counts{24, 48, 96, 192};  // even: a node in the middle shows the height
  std::vector<double> load, height, energy;
  for (const Index edges : counts) {
    const ElasticaShape found = testing::compressed_rod(edges, shortening, clamped);
    load.push_back(std::abs(found.load / (factor * exact.load) - 1));
    height.push_back(std::abs(found.height / exact.height - 1));
    energy.push_back(std::abs(found.energy / (factor * exact.energy) - 1));
  }
  for (const auto& errors : {load, height, energy}) {
    EXPECT_GT(testing::measured_order(counts, errors), 1.9) << shortening;
    // the chain is too soft by (pi / N)^2 / 12, clamped by that of N / 2, however far it bends
    const double soft = std::pow((clamped ? 2 : 1) * pi / 192, 2) / 12;
    EXPECT_LT(errors.back(), 1.3 * soft) << shortening;
  }
}

TEST(ElasticaConvergence, LoadHeightAndEnergyOfThePinnedRodAreOfOrderTwo) {
  expect_order_two(0.3, false);
  expect_order_two(0.8, false);
}

TEST(ElasticaConvergence, LoadHeightAndEnergyOfTheClampedRodAreOfOrderTwo) {
  expect_order_two(0.3, true);
}

}  // namespace
}  // namespace wirepack
