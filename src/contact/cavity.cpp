#include "wirepack/contact/cavity.hpp"

#include <cmath>

#include "wirepack/contact/wall_point.hpp"

namespace wirepack {

Cavity ellipsoid(const Vec3& semi_axes) { return {std::cbrt(semi_axes.prod()), semi_axes}; }

Vec3 semi_axes_of(const Cavity& cavity) {
  return cavity.semi_axes ? *cavity.semi_axes : Vec3::Constant(cavity.radius);
}

double smallest_wall_radius(const Cavity& cavity) {
  const Vec3 axes = semi_axes_of(cavity);
  return axes.minCoeff() * axes.minCoeff() / axes.maxCoeff();
}

double wall_gap(const Cavity& cavity, const Vec3& point, double wire_radius) {
  return with_shape(
      cavity, [&](const auto& shape) { return wall_point(shape, triple(point), wire_radius).gap; });
}

Vec3 outward_normal(const Cavity& cavity, const Vec3& point) {
  return with_shape(cavity, [&](const auto& shape) {
    return Vec3(vec3(wall_point(shape, triple(point), 0).outward).normalized());
  });
}

Mat3 contact_hessian(const Cavity& cavity, const Vec3& point, double overlap, double stiffness) {
  if (!cavity.semi_axes) {
    const double distance = point.norm();
    const Vec3 n = point / distance;
    const double turning = overlap / distance;
    return stiffness * (n * n.transpose() + turning * (Mat3::Identity() - n * n.transpose()));
  }
  const Ellipsoid shape{*cavity.semi_axes};
  const auto at = wall_point(shape, triple(point), 0);
  const Vec3 n = vec3(at.outward) / at.length;
  Mat3 result = n * n.transpose();
  for (Index k = 0; k < 3; ++k) {
    result.col(k) += vec3(normal_turning(shape, at, overlap, triple(Vec3::Unit(k)), triple(n)));
  }
  return stiffness * result;
}

Vec3 touching_point(const Cavity& cavity, const Vec3& inside, double wire_radius) {
  constexpr int steps = 20;  // of Newton's method along the ray; half of them are enough
  const Vec3 ray = inside.normalized();
  double distance = inside.norm();
  for (int k = 0; k < steps; ++k) {
    const Vec3 point = distance * ray;
    distance += wall_gap(cavity, point, wire_radius) / outward_normal(cavity, point).dot(ray);
  }
  return distance * ray;
}

}  // namespace wirepack
