#include <gtest/gtest.h>

#include "../support/cantilevers.hpp"

namespace wirepack {
namespace {

TEST(BatheCantilever, OfNaturalCurvatureBendsOutOfItsPlaneAsComputedFromTheKirchhoffEquations) {
  for (const testing::BatheTip& exact : testing::exact_bathe) {
    const Vec3 tip = testing::bathe_tip(100, exact.force, 1000);  // exact values: inextensible
    for (int c = 0; c < 3; ++c) {
      // order 2: about (l k)^2 / 4 = 6e-5 for k = 0.02, of the tip's way of up to 70
      EXPECT_NEAR(tip[c], exact.tip[static_cast<std::size_t>(c)], 2.5e-3)
          << exact.force << " " << c;
    }
  }
}

TEST(BatheCantilever, AgreesWithSimoAndVuQuoc) {
  // eight shear-flexible elements: 0.3 % of the arc length
  EXPECT_LT((testing::bathe_tip(100, 600) - Vec3(47.23, 15.79, 53.37)).norm(), 0.003 * 78.5);
}

TEST(BatheCantilever, WithoutLoadKeepsItsArc) {
  const Vec3 tip = testing::bathe_tip(100, 1e-6);
  // polygon against arc, (l k)^2 / 12 of the arc length
  EXPECT_LT((tip - Vec3(70.710678, 29.289322, 0)).norm(), 1e-3);
}

}  // namespace
}  // namespace wirepack
