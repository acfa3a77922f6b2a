#pragma once

#include <cmath>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// Third axis of a frame: the tangent of an adapted edge frame.
inline Vec3 third_axis(const Quat& frame) {
  const double w = frame.w(), x = frame.x(), y = frame.y(), z = frame.z();
  return {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
}

/// Smallest rotation that takes unit vector `from` to unit vector `to` (parallel transport).
/// Undefined at to = -from; callers keep turns below pi.
inline Quat transport(const Vec3& from, const Vec3& to) {
  const double w = std::sqrt((1 + from.dot(to)) / 2);
  const Vec3 v = from.cross(to) / (2 * w);
  return {w, v.x(), v.y(), v.z()};
}

/// Rotation by `angle` [rad] about the unit vector `axis`.
inline Quat rotation_about(const Vec3& axis, double angle) {
  const double s = std::sin(angle / 2);
  return {std::cos(angle / 2), s * axis.x(), s * axis.y(), s * axis.z()};
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
