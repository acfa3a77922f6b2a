#pragma once

#include "wirepack/core/types.hpp"

namespace wirepack {

/// A vector whose components are numbers, or lanes of numbers: formulas written once for both.
template <class T>
struct Triple {
  T x, y, z;

  friend Triple operator+(const Triple& a, const Triple& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Triple operator-(const Triple& a, const Triple& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Triple operator*(const T& s, const Triple& a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class T>
T dot(const Triple<T>& a, const Triple<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Triple<double> triple(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
inline Vec3 vec3(const Triple<double>& v) { return {v.x, v.y, v.z}; }

/// A quaternion of numbers or of lanes.
template <class T>
struct QuatOf {
  T w, x, y, z;

  friend QuatOf operator*(const QuatOf& a, const QuatOf& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
            a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
            a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x};
  }
  /// Turns a vector by a unit quaternion.
  friend Triple<T> operator*(const QuatOf& q, const Triple<T>& v) {
    const Triple<T> u{q.x, q.y, q.z};
    const Triple<T> half = cross(u, v);
    return v + T(2.0) * (q.w * half + cross(u, half));
  }
  QuatOf conjugate() const { return {w, -x, -y, -z}; }
};

inline QuatOf<double> quat_of(const Quat& q) { return {q.w(), q.x(), q.y(), q.z()}; }
inline Quat quat(const QuatOf<double>& q) { return {q.w, q.x, q.y, q.z}; }

}  // namespace wirepack
