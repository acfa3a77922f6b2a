#include <gtest/gtest.h>
#include <vector>

#include "wirepack/core/rotation.hpp"

namespace wirepack {
namespace {

// Angle about the first tangent by which a frame has turned after parallel transport along closed
// tangents, in (-pi, pi].
double holonomy(const std::vector<Vec3>& tangents) {
  Quat turn = Quat::Identity();
  for (std::size_t k = 0; k < tangents.size(); ++k) {
    turn = transport(tangents[k], tangents[(k + 1) % tangents.size()]) * turn;
  }
  return nearest_turn(2 * std::atan2(turn.vec().dot(tangents[0]), turn.w()), 0);
}

std::vector<Vec3> cone(int count, double half_angle) {
  std::vector<Vec3> tangents;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * pi * k / count;
    tangents.emplace_back(std::sin(half_angle) * std::cos(angle),
                          std::sin(half_angle) * std::sin(angle), std::cos(half_angle));
  }
  return tangents;
}

TEST(Holonomy, OfAnOctantIsItsAreaAQuarterTurn) {
  EXPECT_NEAR(holonomy({Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}), pi / 2, 1e-15);
  EXPECT_NEAR(holonomy({Vec3::UnitZ(), Vec3::UnitY(), Vec3::UnitX()}), -pi / 2, 1e-15);
}

TEST(Holonomy, OfAPlanePolygonIsZero) {
  for (const int count : {3, 4, 7, 100}) {
    EXPECT_NEAR(holonomy(cone(count, pi / 2)), 0, 1e-13) << count;  // sum of 100 round-offs
  }
}

// In [0, 2 pi): the area that the tangents enclose on the sphere.
double enclosed_area(int count, double half_angle) {
  return nearest_turn(holonomy(cone(count, half_angle)), pi);
}

// Over one turn of a helix the Frenet frame turns against the transported one by the total torsion,
// by Gauss and Bonnet 2 pi less the area: 2 pi cos(theta).
double frenet_minus_bishop(int count, double half_angle) {
  return 2 * pi - enclosed_area(count, half_angle);
}

TEST(Holonomy, OfRegularPolygonsOnAConeIsThatOfTheSphericalPolygon) {
  // printed digits
  EXPECT_NEAR(enclosed_area(4, pi / 3), 2.5740044352, 1e-10);
  EXPECT_NEAR(enclosed_area(8, pi / 3), 3.0156721723, 1e-10);
  EXPECT_NEAR(enclosed_area(16, pi / 3), 3.1110191772, 1e-10);
  EXPECT_NEAR(enclosed_area(32, pi / 3), 3.1340044894, 1e-10);
  for (const int count : {3, 4, 8, 16, 32, 100}) {
    for (const double theta : {pi / 6, pi / 3, 1.4}) {
      // n triangles from the pole, their base angles beta by tan(beta) = cot(pi / n) / cos(theta)
      const double beta = std::atan(1 / (std::tan(pi / count) * std::cos(theta)));
      const double area = count * (2 * pi / count + 2 * beta - pi);
      EXPECT_NEAR(enclosed_area(count, theta), area, 1e-12) << count;  // sum of 100 round-offs
    }
  }
}

TEST(Holonomy, OfAHelixConvergesToTheConeWithOrderTwo) {
  const double exact = 2 * pi * std::cos(pi / 6);
  EXPECT_NEAR(exact, 5.44139809, 1e-8);
  const double coarse = exact - frenet_minus_bishop(100, pi / 6);
  const double fine = exact - frenet_minus_bishop(200, pi / 6);
  EXPECT_LT(std::abs(fine), 2e-4);
  EXPECT_GT(std::log2(coarse / fine), 1.99);
}

}  // namespace
}  // namespace wirepack
