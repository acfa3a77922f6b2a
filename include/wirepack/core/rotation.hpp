#pragma once

#include <cmath>

#include "wirepack/core/triple.hpp"
#include "wirepack/core/types.hpp"

namespace wirepack {

/// Third axis of a frame: the tangent of an adapted edge frame.
template <class T>
Triple<T> third_axis(const QuatOf<T>& q) {
  return {2.0 * (q.x * q.z + q.w * q.y), 2.0 * (q.y * q.z - q.w * q.x),
          1.0 - 2.0 * (q.x * q.x + q.y * q.y)};
}
inline Vec3 third_axis(const Quat& frame) { return vec3(third_axis(quat_of(frame))); }

/// Smallest rotation that takes unit vector `from` to unit vector `to` (parallel transport).
/// Undefined at to = -from; callers keep turns below pi.
template <class T>
QuatOf<T> transport(const Triple<T>& from, const Triple<T>& to) {
  using std::sqrt;
  const T w = sqrt(0.5 * (1.0 + dot(from, to)));
  const Triple<T> v = (0.5 / w) * cross(from, to);
  return {w, v.x, v.y, v.z};
}
inline Quat transport(const Vec3& from, const Vec3& to) {
  return quat(transport(triple(from), triple(to)));
}

/// Rotation by `angle` [rad] about the unit vector `axis`.
template <class T>
QuatOf<T> rotation_about(const Triple<T>& axis, const T& angle) {
  using std::cos, std::sin;
  const T half = 0.5 * angle;
  const Triple<T> v = sin(half) * axis;
  return {cos(half), v.x, v.y, v.z};
}
inline Quat rotation_about(const Vec3& axis, double angle) {
  return quat(rotation_about(triple(axis), angle));
}

/// Any frame whose third axis is the unit vector `tangent`; deterministic.
inline Quat frame_with_tangent(const Vec3& tangent) {
  const Vec3 z = Vec3::UnitZ();
  if (tangent.z() > -0.9) return transport(z, tangent);
  const Quat half_turn(0, 1, 0, 0);  // takes z to -z
  return transport(-z, tangent) * half_turn;
}

/// Number of whole turns (multiples of 2 pi) that brings `angle` within pi of `guide`.
inline double nearest_turn(double angle, double guide) {
  return angle + 2 * pi * std::round((guide - angle) / (2 * pi));
}

}  // namespace wirepack
