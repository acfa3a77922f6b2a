#include "../support/elastica.hpp"

#include <gtest/gtest.h>

namespace wirepack {
namespace {

using testing::compressed_rod;
using testing::ElasticaShape;
using testing::exact_elastica;

TEST(Elastica, TableAgreesWithTheEllipticIntegrals) {
  for (const ElasticaShape& row : exact_elastica) {
    const ElasticaShape exact = testing::elastica_of_shortening(row.shortening);
    EXPECT_NEAR(exact.load, row.load, 1e-8);  // printed digits
    EXPECT_NEAR(exact.height, row.height, 1e-8);
    EXPECT_NEAR(exact.end_degrees, row.end_degrees, 1e-5);
    EXPECT_NEAR(exact.energy, row.energy, 1e-6);
  }
}

// The chain is too soft by pi^2 / (12 N^2), however far it bends; half as much again for heights.
double tolerance(double edges) { return pi * pi / 8 / (edges * edges); }

void expect_near(const ElasticaShape& found, const ElasticaShape& exact, double relative) {
  EXPECT_NEAR(found.load / exact.load, 1, relative) << exact.shortening;
  EXPECT_NEAR(found.height / exact.height, 1, relative) << exact.shortening;
  // the table gives six digits
  EXPECT_NEAR(found.energy / exact.energy, 1, relative + 1e-5) << exact.shortening;
}

TEST(Elastica, PinnedRodFollowsTheExactLoadHeightSlopeAndEnergy) {
  for (const ElasticaShape& exact : exact_elastica) {
    const ElasticaShape found = compressed_rod(100, exact.shortening, false);
    expect_near(found, exact, tolerance(100));
    // the slope is that of the middle of the first edge, cos(pi / 2 N) of that at its end
    EXPECT_NEAR(found.end_degrees / exact.end_degrees, 1,
                tolerance(100) + pi * pi / (8.0 * 100 * 100));
  }
}

// Four quarters of the pinned elastica: its curvature in half the length each, on N / 2 edges.
TEST(Elastica, ClampedRodCarriesFourTimesTheLoadAndEnergyAtTheSameHeight) {
  for (const ElasticaShape& exact : exact_elastica) {
    ElasticaShape found = compressed_rod(100, exact.shortening, true);
    found.load /= 4;
    found.energy /= 4;
    expect_near(found, exact, tolerance(50));
  }
}

}  // namespace
}  // namespace wirepack
