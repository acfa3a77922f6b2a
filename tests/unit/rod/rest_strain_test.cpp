#include "wirepack/rod/rest_strain.hpp"

#include <gtest/gtest.h>

#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/solve/gradient_check.hpp"

#include "../../support/clamped_rod.hpp"
#include "../../support/helices.hpp"

namespace wirepack {
namespace {

using testing::Helix;
using testing::random_rod;

ReferenceShape uniform_shape(const Vec3& darboux, double length) {
  return {DarbouxTable({{0, darboux}, {length, darboux}}), BeyondShape::extend};
}

RodParams wavy_params() {
  RodParams params;
  params.rest_darboux = Vec3(0.02, -0.03, 0);  // as an imperfection adds it
  params.reference_shape = {
      DarbouxTable({{0, Vec3(0.1, 0.2, -0.3)}, {2, Vec3(0.3, 0, -0.3)}, {4.3, Vec3(0, -0.4, 0.6)}}),
      BeyondShape::repeat};
  return params;
}

TEST(RestStrain, UniformBendingIsThatOfAPrecurvedWire) {
  RodParams curved, shaped;
  curved.rest_darboux = Vec3(0, 0.07, 0);
  shaped.reference_shape = uniform_shape(curved.rest_darboux, 3);
  RodState state = random_rod(9, curved, {.first_clamped = true, .last_clamped = true}, 4);
  state.inlet_rest_length = 1.3;
  for (Index i = 0; i < 9; ++i) {
    EXPECT_LT((rest_strain(state, shaped, i) - rest_strain(state, curved, i)).norm(), 1e-15);
    EXPECT_LT(
        (rest_strain_by_inlet(state, shaped, i) - rest_strain_by_inlet(state, curved, i)).norm(),
        1e-15);
  }
}

TEST(RestStrain, OfTheWireInsideDoesNotChangeByFeeding) {
  const RodParams params = wavy_params();
  const RodEnds ends{.last_clamped = true};
  RodState before = random_rod(9, params, ends, 4), after = random_rod(10, params, ends, 4);
  before.inlet_rest_length = 0.9;
  after.inlet_rest_length = 0.6;
  for (Index i = 1; i < 7; ++i) {
    EXPECT_EQ(rest_strain(before, params, i), rest_strain(after, params, i));
  }
}

TEST(RestStrain, GradientAndForceOfInsertionMatchDifferences) {
  const RodParams params = wavy_params();
  for (const RodEnds& ends : {RodEnds{}, RodEnds{.last_clamped = true},
                              RodEnds{.first_clamped = true, .last_clamped = true}}) {
    for (const double inlet : {0.7, 1.3}) {  // not 0.6, where k0 has a kink at the clamp
      RodState state = random_rod(12, params, ends, 5);
      state.inlet_rest_length = inlet;
      JointEnergy energy(params);
      const auto functions = EnergyTerms{energy};
      const FrameChart chart(state, HeldUnknowns::none(state));
      const Eigen::VectorXd offset = Eigen::VectorXd::LinSpaced(chart.size(), -0.1, 0.1);
      const GradientCheck all =
          check_gradient(state, HeldUnknowns::none(state), functions, offset, 1e-6);
      EXPECT_GT(all.largest_derivative, 1e-3);
      EXPECT_LT(all.relative_error, 1e-8);
      const GradientCheck by_length = check_inlet_derivative(state, functions, 1e-6);
      EXPECT_GT(by_length.largest_derivative, 1e-4);
      // one number, so no larger one hides its rounding
      EXPECT_LT(by_length.relative_error, 1e-6);
    }
  }
}

// A straight wire in the nozzle, let go: it winds itself up into its reference shape.
RodState released(const RodParams& params, Index edges) {
  auto [state, held] = testing::clamped_rod(edges, params, {.last_clamped = true});
  testing::rest(state, held, params);
  return state;
}

TEST(RestStrain, FreeWireTakesAHelixOfEitherHandWithoutEnergy) {
  for (const double torsion : {0.5, -0.5}) {
    const Helix helix{1, torsion};
    RodParams params = testing::unit_rod(100, 12);
    params.reference_shape = uniform_shape(Vec3(0, helix.curvature, helix.torsion), 1);
    const RodState state = released(params, 100);
    const testing::MeasuredHelix found = testing::measured_helix(state);
    // l k = 0.12 per joint: (l k)^2 / 12 = 1.2e-3; right-handed (pitch > 0) for positive torsion
    EXPECT_NEAR(found.radius / helix.radius(), 1, 2e-3);
    EXPECT_NEAR(found.pitch / helix.pitch(), 1, 2e-3);
    EXPECT_NEAR(testing::elastic_energy(state, params), 0, 1e-10);  // straight it was 6
  }
}

TEST(RestStrain, TheTipHasTheCurvatureOfTheFirstRows) {
  RodParams params = testing::unit_rod(80, 8);
  params.reference_shape = {DarbouxTable(
      {{0, Vec3(0, 0.5, 0)}, {4, Vec3(0, 0.5, 0)}, {4.1, Vec3(0, 1, 0)}, {8, Vec3(0, 1, 0)}})};
  const RodState state = released(params, 80);
  const auto curvature = [&](Index i) {
    return joint_strain(state.frames[static_cast<std::size_t>(i - 1)],
                        state.frames[static_cast<std::size_t>(i)], 0)
               .norm() /
           params.edge_length;
  };
  EXPECT_NEAR(curvature(20), 0.5, 1e-6);
  EXPECT_NEAR(curvature(60), 1.0, 1e-6);
}

}  // namespace
}  // namespace wirepack
