#include "wirepack/fit/shape_fit.hpp"

#include <gtest/gtest.h>

#include "wirepack/core/error.hpp"
#include "wirepack/fit/darboux_curve.hpp"

#include "../support/fit_trials.hpp"
#include "../support/helices.hpp"
#include "../support/measured_wires.hpp"

namespace wirepack {
namespace {

using testing::curvature;
using testing::fitted;
using testing::helix_points;
using testing::measured;
using testing::normal_noise;
using testing::Number;
using testing::pitch;
using testing::radius;
using testing::shuffled;
using testing::torsion;
using testing::Trials;
using testing::trials;

// Points on a circle arc of radius 1, ends included (but once around).
Points arc_points(double turns) { return helix_points(100, 1, 0, turns, turns < 1, 3); }

TEST(CircleFit, ExactPointsGiveTheCircleBackInAnyOrder) {
  for (const double turns : {1.0, 0.5, 0.125, 0.02}) {
    for (const bool ordered : {true, false}) {
      MeasuredPoints points = measured(arc_points(turns));
      if (!ordered) points = shuffled(points, 5);
      const ShapeFit fit = fitted(points, ShapeModel::circle);
      // arcs of 7 degrees multiply round-off by 2e3
      const double tolerance = turns < 0.1 ? 1e-9 : 1e-10;
      EXPECT_NEAR(fit.numbers[radius].value, 1, tolerance) << turns;
      EXPECT_NEAR(fit.numbers[curvature].value, 1, tolerance) << turns;
      EXPECT_NEAR(fit.length, turns == 1 && ordered ? 2 * pi * 0.99 : 2 * pi * turns, 1e-9);
    }
  }
}

// Standard errors over the scatter of a coordinate.
double error_over_noise(const ShapeFit& fit, Number number) {
  return fit.numbers[number].standard_error / fit.noise;
}

TEST(CircleFit, StandardErrorsAreTheCramerRaoBounds) {
  Random random(1);
  const auto error = [&](double turns) {
    const Points points = arc_points(turns) + normal_noise(100, 1e-6, random);
    return error_over_noise(fitted(measured(points), ShapeModel::circle), radius);
  };
  // closed forms; the derivatives at noisy points differ by the scatter
  EXPECT_NEAR(error(1), 0.1, 1e-5);
  EXPECT_NEAR(error(0.5), 0.224920, 1e-5);
  EXPECT_NEAR(error(0.125), 4.201679, 1e-3);
}

TEST(HelixFit, ExactPointsGiveTheHelixBack) {
  for (const double turns : {0.1, 0.4, 1.0, 5.0}) {
    for (const double slope : {0.2, -0.2}) {
      const ShapeFit fit =
          fitted(measured(helix_points(100, 1, slope, turns, true, 4)), ShapeModel::helix);
      EXPECT_NEAR(fit.numbers[curvature].value, 1 / 1.04, 1e-9) << turns;
      EXPECT_NEAR(fit.numbers[torsion].value, slope / 1.04, 1e-9) << turns;
      EXPECT_NEAR(fit.numbers[radius].value, 1, 1e-9) << turns;
      EXPECT_NEAR(fit.numbers[pitch].value, 2 * pi * slope, 1e-9) << turns;
      EXPECT_NEAR(fit.length, 2 * pi * turns * std::sqrt(1.04), 1e-9) << turns;
    }
  }
}

TEST(HelixFit, StandardErrorsAreTheCramerRaoBounds) {
  Random random(2);
  struct Case {
    Index count;
    double turns, radius, slope, curvature, torsion;
  };
  // computed once from the Fisher information of orthogonal distances
  for (const Case& c : {Case{100, 1, .108223, .078521, .092605, .089182},
                        Case{200, 5, .071375, .007930, .063394, .027376}}) {
    const Points points =
        helix_points(c.count, 1, 0.2, c.turns, true, 4) + normal_noise(c.count, 1e-6, random);
    const ShapeFit fit = fitted(measured(points), ShapeModel::helix);
    EXPECT_NEAR(error_over_noise(fit, radius), c.radius, 1e-4);
    EXPECT_NEAR(error_over_noise(fit, pitch) / (2 * pi), c.slope, 1e-4);
    EXPECT_NEAR(error_over_noise(fit, curvature), c.curvature, 1e-4);
    EXPECT_NEAR(error_over_noise(fit, torsion), c.torsion, 1e-4);
  }
}

TEST(CircleFit, ShortArcsAreNotBiasedAndScatterByTheirErrors) {
  // A scatter of 7 % of the sagitta, where algebraic fits shrink the circle.
  const double sigma = 0.005;
  const Trials found =
      trials(arc_points(0.125), ShapeModel::circle, curvature, 1, sigma, 500, 4.201679 * sigma);
  EXPECT_LT(std::abs(found.bias), 0.1);
  EXPECT_NEAR(found.scatter, 1, 0.1);  // known to 1 / sqrt(2 * 500) = 3 %
}

TEST(HelixFit, IsNotBiasedAndScattersByItsErrors) {
  const double sigma = 0.01;
  const Points exact = helix_points(100, 1, 0.2, 1, true, 4);
  const Trials found =
      trials(exact, ShapeModel::helix, curvature, 1 / 1.04, sigma, 100, 0.092605 * sigma);
  EXPECT_LT(std::abs(found.bias), 0.1);
  EXPECT_NEAR(found.scatter, 1, 0.21);  // known to 7 % from 100 pairs
}

MeasuredPoints registered_arc(double length, double sigma, std::uint64_t seed) {
  Random random(seed);
  MeasuredPoints points = measured(Points(3, 100));
  points.arc = Eigen::VectorXd::LinSpaced(100, 5, 5 + length);
  for (Index i = 0; i < 100; ++i) {
    const double s = points.arc[i] - 5;
    points.position.col(i) = Vec3(std::sin(s), 1 - std::cos(s), 0);
  }
  points.position += normal_noise(100, sigma, random);
  return points;
}

TEST(RegisteredFit, CurvatureHasTheErrorsOfKnownArcs) {
  for (const auto& [length, error] : {std::pair{1.0, 2.542748}, std::pair{2.0, .587933}}) {
    const ShapeFit circle = fitted(registered_arc(length, 1e-6, 1), ShapeModel::circle);
    EXPECT_NEAR(error_over_noise(circle, curvature), error, 1e-4);
    const ShapeFit helix = fitted(registered_arc(length, 1e-6, 1), ShapeModel::helix);
    EXPECT_NEAR(error_over_noise(helix, curvature), error, 1e-4);
  }
}

// A rod with k0 a random spline, on which points lie at known arcs.
struct SampleRod {
  DarbouxCurve curve;
  MeasuredPoints points;
};

SampleRod spline_rod(Index count, double sigma) {
  Random random(6);
  const DarbouxBasis basis{6, false, 0, 20};
  SampleRod rod{DarbouxCurve(basis, {testing::random_rotation(random).toRotationMatrix(),
                                     testing::random_vector(random)}),
                measured(Points(3, count))};
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(rod.curve.size());
  for (double& u : unknowns.tail(basis.size())) u = 0.2 + 0.3 * random.symmetric();
  rod.curve.set_unknowns(unknowns, false);
  rod.points.arc = Eigen::VectorXd::LinSpaced(count, 0, 20);
  for (Index i = 0; i < count; ++i) {
    rod.points.position.col(i) = rod.curve.at(rod.points.arc[i]).position;
  }
  rod.points.position += normal_noise(count, sigma, random);
  return rod;
}

TEST(SplineFit, GivesBackTheRestShapeOfARodMadeByTheProgram) {
  const SampleRod rod = spline_rod(200, 0);
  const ShapeFit fit = fit_shape(rod.points, {ShapeModel::spline, false, 6});
  EXPECT_LT(fit.residual_rms, 1e-10);
  for (const DarbouxRow& row : fit.shape.table.rows()) {
    // the frame may be turned about the tangent, as a whole
    EXPECT_NEAR(row.darboux.norm(), rod.curve.darboux(row.arc).norm(), 1e-9);
  }
}

TEST(SplineFit, ResidualsAreThoseOfTheScatter) {
  for (const bool arcs : {true, false}) {
    MeasuredPoints points = spline_rod(300, 0.01).points;
    if (!arcs) points.arc.resize(0);
    points.sigma = Eigen::VectorXd::Constant(300, 0.01);
    const ShapeFit fit = fitted(points, ShapeModel::spline);
    const double freedom = static_cast<double>(fit.degrees_of_freedom);
    EXPECT_EQ(fit.degrees_of_freedom, (arcs ? 3 : 2) * 300 - fit.unknowns);
    EXPECT_NEAR(*fit.chi_square / freedom, 1, 3 * std::sqrt(2 / freedom));
  }
}

TEST(SplineFit, TheTableIsTheFittedCurve) {
  MeasuredPoints points = spline_rod(300, 0).points;
  points.arc.resize(0);
  const ShapeFit fit = fit_shape(points, {ShapeModel::spline, false, 12});
  // integrate k0(s) of the table from the first drawn point on, by small turns
  const DarbouxTable& table = fit.shape.table;
  constexpr int steps = 20000;
  const double step = table.length() / steps;
  Quat frame = Quat::Identity();
  Vec3 end = Vec3::Zero();
  for (int i = 0; i < steps; ++i) {
    const Vec3 turn = step * table.darboux((i + 0.5) * step);
    const Quat half(Eigen::AngleAxisd(turn.norm() / 2, turn.normalized()));
    frame = frame * half;
    end += step * third_axis(frame);
    frame = frame * half;
  }
  const double across = (fit.curve.rightCols(1) - fit.curve.leftCols(1)).norm();
  EXPECT_NEAR(end.norm() / across, 1, 2e-3);  // linear between rows against pieces of a spline
}

TEST(ShapeFit, OfAWireAtRestIsTheShapeItWasGiven) {
  const testing::Helix helix{1, 0.5};
  RodParams params = testing::unit_rod(60, 12);
  params.reference_shape = {DarbouxTable({{0, Vec3(0, helix.curvature, helix.torsion)},
                                          {1, Vec3(0, helix.curvature, helix.torsion)}}),
                            BeyondShape::extend};
  RodState state = make_rod(testing::straight_nodes(60, 12), params, {.last_clamped = true});
  HeldUnknowns held = HeldUnknowns::none(state);
  held.hold_node(60);
  testing::hold_angle(held, state.last_clamp_frame());
  testing::rest(state, held, params);
  // the edges at the clamp start along it, and so lie off the helix
  const ShapeFit fit = fitted(measured(state.nodes.leftCols(59)), ShapeModel::helix);
  EXPECT_LT(fit.residual_rms,
            1e-7);  // nodes of equal joints lie on a helix; the rest is the solver
  // l k = 0.2 per joint: (l k)^2 / 12 = 3.3e-3
  EXPECT_NEAR(fit.numbers[curvature].value, helix.curvature, 5e-3);
  EXPECT_NEAR(fit.numbers[torsion].value, helix.torsion, 5e-3);
}

TEST(ShapeFit, OfAStraightWireSaysWhatThePointsDoNotTell) {
  Random random(8);
  MeasuredPoints line = measured(testing::straight_nodes(49, 20));
  for (const double sigma : {0.0, 0.01}) {
    line.position += normal_noise(50, sigma, random);
    const ShapeFit circle = fitted(line, ShapeModel::circle);
    EXPECT_TRUE(circle.numbers[curvature].determined);
    EXPECT_NEAR(circle.numbers[curvature].value, 0, 4 * circle.numbers[curvature].standard_error);
    EXPECT_FALSE(circle.numbers[radius].determined);
    const ShapeFit helix = fitted(line, ShapeModel::helix);
    EXPECT_FALSE(helix.numbers[torsion].determined);
    EXPECT_FALSE(helix.numbers[pitch].determined);
    EXPECT_EQ(helix.rank, sigma == 0 ? helix.unknowns - 1 : helix.unknowns);
    EXPECT_NEAR(fitted(line, ShapeModel::spline).length, 20, 4 * sigma + 1e-9);
  }
}

TEST(ShapeFit, TorsionOfAPlaneCurveIsFoundToBeZero) {
  Random random(9);
  const Points points = arc_points(1) + normal_noise(100, 0.001, random);
  const ShapeFit fit = fitted(measured(points), ShapeModel::helix);
  EXPECT_TRUE(fit.numbers[torsion].determined);
  EXPECT_NEAR(fit.numbers[torsion].value, 0, 3 * fit.numbers[torsion].standard_error);
}

TEST(ShapeFit, RobustFitIsHardlyMovedByOutliersAndBothNameThem) {
  Random random(5);
  Points points = helix_points(100, 1, 0.2, 1, true, 3) + normal_noise(100, 1e-3, random);
  points.col(7) += Vec3(0.1, 0.2, 0);
  points.col(60) -= Vec3(0.1, 0.2, 0.1);
  const std::vector<Index> spoilt{7, 60};
  const ShapeFit plain = fit_shape(measured(points), {ShapeModel::helix, false, {}});
  const ShapeFit robust = fit_shape(measured(points), {ShapeModel::helix, true, {}});
  EXPECT_EQ(plain.outliers, spoilt);
  EXPECT_EQ(robust.outliers, spoilt);
  EXPECT_NEAR(robust.numbers[curvature].value, 1 / 1.04, 4 * 0.0926e-3);
  EXPECT_GT(std::abs(plain.numbers[curvature].value - 1 / 1.04), 10 * 0.0926e-3);
  EXPECT_NEAR(robust.noise, 1e-3, 0.15e-3);
}

TEST(ShapeFit, UnorderedPointsGiveTheSameShape) {
  Random random(12);
  for (const double turns : {0.4, 1.0, 2.5, 6.0}) {
    const MeasuredPoints points =
        measured(helix_points(300, 1, -0.2, turns, true, 3) + normal_noise(300, 1e-3, random));
    for (const ShapeModel model : {ShapeModel::helix, ShapeModel::spline}) {
      const ShapeFit one = fitted(points, model), other = fitted(shuffled(points, 4), model);
      EXPECT_NEAR(one.numbers[curvature].value, other.numbers[curvature].value,
                  one.numbers[curvature].standard_error)
          << turns;
      EXPECT_NEAR(one.length, other.length, 0.01) << turns;
    }
  }
}

TEST(ShapeFit, PointsThatCannotDetermineAModelAreRefused) {
  Points two(3, 2);
  two << 0, 1, 0, 0, 0, 0;
  EXPECT_THROW(fit_shape(measured(two), {ShapeModel::circle, false, {}}), InvalidInput);
  const Points repeated = two.col(0).replicate(1, 20);
  EXPECT_THROW(fit_shape(measured(repeated), {ShapeModel::helix, false, {}}), InvalidInput);
  Random random(1);
  const MeasuredPoints cloud = measured(normal_noise(200, 1, random), false);
  EXPECT_THROW(fit_shape(cloud, {ShapeModel::spline, false, {}}), InvalidInput);
}

}  // namespace
}  // namespace wirepack
