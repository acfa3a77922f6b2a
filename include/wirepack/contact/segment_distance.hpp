#pragma once

#include "wirepack/core/lanes.hpp"
#include "wirepack/core/types.hpp"

namespace wirepack {

/// Squared distance between the segments p0 p1 and q0 q1; exact also when they are parallel or
/// have no length. T is double, or Lanes for four pairs at once.
template <class T>
T squared_segment_distance(const Triple<T>& p0, const Triple<T>& p1, const Triple<T>& q0,
                           const Triple<T>& q1) {
  const Triple<T> u = p1 - p0;
  const Triple<T> v = q1 - q0;
  const T uu = dot(u, u), vv = dot(v, v), uv = dot(u, v);
  const T zero(0.0), one(1.0);
  const auto lesser = [](const T& a, const T& b) { return select(b < a, b, a); };
  const auto from_end = [&](const Triple<T>& point, const Triple<T>& start, const Triple<T>& along,
                            const T& squared_length) {
    const Triple<T> d = point - start;
    const T raw = dot(d, along) / select(squared_length > 0.0, squared_length, one);
    const Triple<T> gap = d - select(raw > one, one, select(raw < zero, zero, raw)) * along;
    return dot(gap, gap);
  };
  // Nearest points are either inside both segments, or one of them is an end point.
  const T ends = lesser(lesser(from_end(p0, q0, v, vv), from_end(p1, q0, v, vv)),
                        lesser(from_end(q0, p0, u, uu), from_end(q1, p0, u, uu)));
  const Triple<T> w = p0 - q0;
  const T uw = dot(u, w), vw = dot(v, w);
  const T determinant = uu * vv - uv * uv;
  const auto crosses = determinant > 1e-14 * uu * vv;
  const T divisor = select(crosses, determinant, one);
  const T s = (uv * vw - vv * uw) / divisor;
  const T t = (uu * vw - uv * uw) / divisor;
  const auto inside = crosses && s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0;
  const Triple<T> between = w + s * u - t * v;
  return select(inside, dot(between, between), ends);
}

inline double squared_segment_distance(const Vec3& p0, const Vec3& p1, const Vec3& q0,
                                       const Vec3& q1) {
  return squared_segment_distance(triple(p0), triple(p1), triple(q0), triple(q1));
}

}  // namespace wirepack
