#include "wirepack/fit/darboux_curve.hpp"

#include <gtest/gtest.h>

#include "../../support/helices.hpp"
#include "../../support/sample_rods.hpp"

namespace wirepack {
namespace {

using testing::random_rotation;
using testing::random_vector;

DarbouxCurve random_curve(const DarbouxBasis& basis, std::uint64_t seed) {
  Random random(seed);
  DarbouxCurve curve(basis, {random_rotation(random).toRotationMatrix(), random_vector(random)});
  Eigen::VectorXd unknowns(curve.size());
  for (double& u : unknowns) u = random.symmetric();
  curve.set_unknowns(unknowns, true);
  return curve;
}

TEST(DarbouxCurve, OfConstantK0IsTheHelixOfThatCurvatureAndTorsion) {
  const testing::Helix helix{0.7, -0.3};
  const DarbouxBasis basis{0, false, -1, 5};
  DarbouxCurve curve(basis, {helix.frame(2).toRotationMatrix(), helix.point(2)});
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(curve.size());
  unknowns.tail<3>() << helix.curvature, 0, helix.torsion;
  curve.set_unknowns(unknowns, false);
  for (const double s : {-31.0, -1.2, 2.0, 2.0001, 3.4, 57.0}) {
    EXPECT_LT((curve.at(s).position - helix.point(s)).norm(), 1e-12) << s;
    EXPECT_LT((curve.at(s).directors.col(2) - helix.tangent(s)).norm(), 1e-12) << s;
  }
}

TEST(DarbouxCurve, DerivativesMatchDifferences) {
  for (const DarbouxBasis& basis :
       {DarbouxBasis{0, true, 0, 4}, DarbouxBasis{0, false, 0, 4}, DarbouxBasis{3, false, 0, 4}}) {
    const DarbouxCurve curve = random_curve(basis, 7);
    for (const double s : {-0.3, 0.4, 1.9, 2.1, 3.3, 4.5}) {
      Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> exact(3, curve.size());
      curve.by_unknowns(s, curve.at(s), Mat3::Identity(), exact);
      for (Index i = 0; i < curve.size(); ++i) {
        constexpr double h = 1e-5;
        DarbouxCurve up = curve, down = curve;
        Eigen::VectorXd u = curve.unknowns();
        u[i] += h;
        up.set_unknowns(u, false);
        u[i] -= 2 * h;
        down.set_unknowns(u, false);
        const Vec3 difference = (up.at(s).position - down.at(s).position) / (2 * h);
        EXPECT_LT((exact.col(i) - difference).norm(), 1e-8) << s << " " << i;
      }
    }
  }
}

TEST(DarbouxCurve, FootIsTheNearestPlaceOnTheCurve) {
  const DarbouxCurve curve = random_curve({3, false, 0, 4}, 9);
  Random random(3);
  for (const double s : {0.5, 1.7, 3.1}) {
    const Vec3 point = curve.at(s).position + 0.1 * random_vector(random);
    const double foot = curve.foot(point, s);
    const DarbouxCurve::Pose there = curve.at(foot);
    EXPECT_NEAR(there.directors.col(2).dot(point - there.position), 0, 1e-12);
    const double distance = (point - there.position).norm();
    EXPECT_LT(distance, (point - curve.at(foot + 0.01).position).norm());
    EXPECT_LT(distance, (point - curve.at(foot - 0.01).position).norm());
  }
}

TEST(DarbouxCurve, IsSmoothAcrossItsPieces) {
  const DarbouxCurve curve = random_curve({3, false, 0, 4}, 11);
  for (double s = -0.2; s < 4.2; s += 1e-3) {
    const DarbouxCurve::Pose a = curve.at(s), b = curve.at(s + 1e-6);
    EXPECT_NEAR((b.position - a.position).norm(), 1e-6, 1e-11);
    EXPECT_LT((b.directors - a.directors).norm(), 1e-5);
  }
}

}  // namespace
}  // namespace wirepack
