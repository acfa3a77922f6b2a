#include "wirepack/contact/segment_distance.hpp"

#include <algorithm>

namespace wirepack {

namespace {

// Parameter of the point of the segment a + u d nearest to p.
double nearest_parameter(const Vec3& p, const Vec3& a, const Vec3& d) {
  const double dd = d.squaredNorm();
  return dd > 0 ? std::clamp((p - a).dot(d) / dd, 0.0, 1.0) : 0.0;
}

}  // namespace

double squared_segment_distance(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
  const Vec3 u = p1 - p0;
  const Vec3 v = q1 - q0;
  const Vec3 w = p0 - q0;
  const double uu = u.squaredNorm();
  const double vv = v.squaredNorm();
  const double uv = u.dot(v);
  const double determinant = uu * vv - uv * uv;
  // Nearest points are either inside both segments, or one of them is an end point.
  if (determinant > 1e-14 * uu * vv) {
    const double s = (uv * v.dot(w) - vv * u.dot(w)) / determinant;
    const double t = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) return (w + s * u - t * v).squaredNorm();
  }
  const auto to_second = [&](const Vec3& p) {
    return (p - q0 - nearest_parameter(p, q0, v) * v).squaredNorm();
  };
  const auto to_first = [&](const Vec3& q) {
    return (q - p0 - nearest_parameter(q, p0, u) * u).squaredNorm();
  };
  return std::min({to_second(p0), to_second(p1), to_first(q0), to_first(q1)});
}

}  // namespace wirepack
