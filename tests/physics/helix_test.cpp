#include <gtest/gtest.h>

#include "../support/helices.hpp"

namespace wirepack {
namespace {

using testing::Helix;
using testing::ReleasedHelix;
using testing::Wrench;

TEST(Helix, RodOfUniformRestCurvatureAndTorsionWindsItselfUpWithoutEnergy) {
  const Helix rest_shape{1, 0.5};
  EXPECT_NEAR(rest_shape.radius(), 0.8, 1e-12);
  EXPECT_NEAR(rest_shape.pitch(), 2.513274, 1e-6);
  const ReleasedHelix found = testing::released_helix(100, rest_shape);
  // l k = 0.12 per joint: (l k)^2 / 12 = 1.2e-3
  EXPECT_NEAR(found.shape.radius / rest_shape.radius(), 1, 2e-3);
  EXPECT_NEAR(found.shape.pitch / rest_shape.pitch(), 1, 2e-3);
  EXPECT_NEAR(found.energy, 0, 1e-10);  // squares of strains left at rest; straight it was 7.5
}

TEST(Helix, IsLeftHandedForNegativeRestTorsion) {
  const Helix rest_shape{1, -0.5};
  const ReleasedHelix found = testing::released_helix(100, rest_shape);
  EXPECT_NEAR(found.shape.radius / rest_shape.radius(), 1, 2e-3);
  EXPECT_NEAR(found.shape.pitch / rest_shape.pitch(), 1, 2e-3);  // both negative
}

TEST(Helix, PulledRingSpringCarriesTheWrenchOfKirchhoff) {
  const Helix held{0.9, 0.3};
  const Wrench exact = testing::exact_wrench(held, 1, 0, 1, 2.0 / 3);
  EXPECT_NEAR(exact.force, 0.221359, 1e-6);
  EXPECT_NEAR(exact.moment, -0.031623, 1e-6);
  const Wrench found = testing::held_helix(200, held);
  // (l k)^2 / 12 = 2e-4 of the bending moment 0.1 and of curvatures that nearly cancel in it
  EXPECT_NEAR(found.force, exact.force, 5e-4);
  EXPECT_NEAR(found.moment, exact.moment, 5e-4);
}

TEST(Helix, PulledRingSpringOfEitherHandPullsAlikeAndTwistsAlike) {
  // the mirror image of a spring without torsion: same force, opposite moment about the same axis
  const Wrench right = testing::held_helix(60, Helix{0.9, 0.3});
  const Wrench left = testing::held_helix(60, Helix{0.9, -0.3});
  EXPECT_NEAR(left.force, -right.force, 1e-5);  // its end lies below its start
  EXPECT_NEAR(left.moment, right.moment, 1e-5);
}

}  // namespace
}  // namespace wirepack
