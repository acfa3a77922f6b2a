#pragma once

#include <array>
#include <experimental/simd>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// Four numbers computed on at once, in one vector register where the machine has them (Parallelism
/// TS 2). The width is fixed, so that results do not depend on it.
inline constexpr int lane_count = 4;
using Lanes =
    std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, lane_count>>;
using LaneMask = Lanes::mask_type;

/// Lane k holds f(k), k = 0 ... 3.
template <class F>
[[gnu::always_inline]] inline Lanes lanes_of(F&& f) {
  return Lanes([&](auto k) { return static_cast<double>(f(static_cast<int>(k))); });
}

/// condition ? a : b, for numbers and lane by lane.
inline double select(bool condition, double a, double b) { return condition ? a : b; }
inline Lanes select(const LaneMask& condition, const Lanes& a, Lanes b) {
  where(condition, b) = a;
  return b;
}

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

/// Columns index(0) ... index(3) of the points, one per lane.
template <class F>
[[gnu::always_inline]] inline Triple<Lanes> columns_of(const Points& points, F&& index) {
  const double* const data = points.data();
  std::array<const double*, lane_count> column;
  for (int k = 0; k < lane_count; ++k) column[static_cast<std::size_t>(k)] = data + 3 * index(k);
  const auto component = [&](int c) {
    return lanes_of([&](int k) { return column[static_cast<std::size_t>(k)][c]; });
  };
  return {component(0), component(1), component(2)};
}

/// One lane of a vector.
inline Vec3 lane(const Triple<Lanes>& v, int k) {
  const auto i = static_cast<std::size_t>(k);
  return {v.x[i], v.y[i], v.z[i]};
}

}  // namespace wirepack
