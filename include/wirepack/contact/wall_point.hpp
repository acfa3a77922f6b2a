#pragma once

#include <cmath>

#include "wirepack/contact/cavity.hpp"
#include "wirepack/core/lanes.hpp"
#include "wirepack/core/triple.hpp"

namespace wirepack {

/// Gap and normal of the wall at a centreline point. Formulas are templates, for a number or lanes.
template <class T>
struct WallPoint {
  T gap;                  ///< see wall_gap()
  Triple<T> outward;      ///< along the normal at the nearest point of the wall, out of the cavity
  T length;               ///< |outward|
  T multiplier = T(0.0);  ///< of an ellipsoid: t of its nearest point
};

struct Sphere {
  double radius;
};

template <class T>
WallPoint<T> wall_point(const Sphere& sphere, const Triple<T>& r, double wire_radius) {
  using std::sqrt;
  const T distance = sqrt(dot(r, r));
  return {sphere.radius - distance - wire_radius, r, distance};
}

/// factor (dn/dr) v, the change of the outward unit normal n when r moves by v.
template <class T>
Triple<T> normal_turning(const Sphere&, const WallPoint<T>& at, const T& factor, const Triple<T>& v,
                         const Triple<T>& n) {
  return (factor / at.length) * (v - dot(v, n) * n);
}

/// (x / e_x)^2 + (y / e_y)^2 + (z / e_z)^2 = 1.
struct Ellipsoid {
  Vec3 semi_axes;
};

/// Finds the nearest point q of the ellipsoid: q_i = e_i^2 w_i, w_i = r_i / (e_i^2 + t) along the
/// normal. The multiplier t puts q on the ellipsoid: sum (e_i w_i)^2 = 1. Newton's method solves
/// 1 / sqrt(sum (e_i w_i)^2) - 1 = 0, which is concave in t, rises with t, and is linear for a
/// sphere. So the steps overshoot once at most, and are stopped at the lower bound
/// e_i (|r_i| - e_i) of t. Their number is fixed, for lanes.
template <class T>
WallPoint<T> wall_point(const Ellipsoid& ellipsoid, const Triple<T>& r, double wire_radius) {
  using std::sqrt;
  constexpr int steps = 8;
  const Vec3& e = ellipsoid.semi_axes;
  const auto larger = [](const T& a, const T& b) { return select(a > b, a, b); };
  // lower bound of t by one axis; above -e_i^2 also at the centre, so nothing is divided by zero
  const auto least = [&](double axis, const T& x) {
    return axis * (larger(larger(x, T(0.0) - x), T(1e-12 * axis)) - axis);
  };
  const T lowest = larger(larger(least(e.x(), r.x), least(e.y(), r.y)), least(e.z(), r.z));
  const Triple<T> scaled{r.x / e.x(), r.y / e.y(), r.z / e.z()};
  const T size = sqrt(dot(scaled, scaled));
  T t = 0.0;
  for (int k = 0; k < steps; ++k) {
    const Triple<T> spread{t + e.x() * e.x(), t + e.y() * e.y(), t + e.z() * e.z()};
    const Triple<T> v{e.x() * r.x / spread.x, e.y() * r.y / spread.y, e.z() * r.z / spread.z};
    const Triple<T> by_t{v.x / spread.x, v.y / spread.y, v.z / spread.z};
    const T square = dot(v, v);
    t = larger(t + (sqrt(square) - 1.0) * square / dot(v, by_t), lowest);
  }
  const Triple<T> w{r.x / (t + e.x() * e.x()), r.y / (t + e.y() * e.y()),
                    r.z / (t + e.z() * e.z())};
  const T length = sqrt(dot(w, w));
  // deep inside there may be no t: then the gap is that of the shrunk ellipsoid through the point
  const T depth = T(0.0) - t * length;
  const T least_depth = select(size < 1.0, (1.0 - size) * e.minCoeff(), depth);
  return {larger(depth, least_depth) - wire_radius, w, length, t};
}

/// The same, by the derivatives of w_i = r_i / (e_i^2 + t) and of sum (e_i w_i)^2 = 1.
template <class T>
Triple<T> normal_turning(const Ellipsoid& ellipsoid, const WallPoint<T>& at, const T& factor,
                         const Triple<T>& v, const Triple<T>& n) {
  const Vec3& e = ellipsoid.semi_axes;
  const T t = at.multiplier;
  const Triple<T>& w = at.outward;
  const Triple<T> m{1.0 / (t + e.x() * e.x()), 1.0 / (t + e.y() * e.y()),
                    1.0 / (t + e.z() * e.z())};
  const Triple<T> weighted{e.x() * e.x() * w.x * m.x, e.y() * e.y() * w.y * m.y,
                           e.z() * e.z() * w.z * m.z};
  const T by_t = dot(weighted, v) / dot(weighted, w);
  const Triple<T> change{m.x * (v.x - by_t * w.x), m.y * (v.y - by_t * w.y),
                         m.z * (v.z - by_t * w.z)};
  return (factor / at.length) * (change - dot(change, n) * n);
}

/// Calls f with the shape of the cavity: formulas are chosen once, and not at each point.
template <class F>
decltype(auto) with_shape(const Cavity& cavity, F&& f) {
  return cavity.semi_axes ? f(Ellipsoid{*cavity.semi_axes}) : f(Sphere{cavity.radius});
}

}  // namespace wirepack
