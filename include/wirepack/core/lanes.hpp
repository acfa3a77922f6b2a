#pragma once

#include <array>
#include <cstring>
#include <experimental/simd>
#include <type_traits>

#include "wirepack/core/triple.hpp"
#include "wirepack/core/types.hpp"

namespace wirepack {

/// Four numbers computed at once, in one vector register where the machine has such (Parallelism
/// TS 2). The width is the same everywhere, so that results do not depend on that of the machine.
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

/// Calls f.operator()<Lanes>(j) for j = first, first + 4, ... and f.operator()<double>(j) for the
/// indices left before `end`. So one formula, a template of the number type, serves both.
template <class F>
[[gnu::always_inline]] inline void for_each_in_lanes(Index first, Index end, F&& f) {
  for (; first + lane_count <= end; first += lane_count) f.template operator()<Lanes>(first);
  for (; first < end; ++first) f.template operator()<double>(first);
}

/// A sum of numbers and of lanes, always added up in the same order.
class LaneSum {
 public:
  void add(const Lanes& v) { lanes_ += v; }
  void add(double v) { rest_ += v; }
  double total() const { return (lanes_[0] + lanes_[1]) + (lanes_[2] + lanes_[3]) + rest_; }

 private:
  Lanes lanes_ = 0.0;
  double rest_ = 0;
};

/// Columns index(0) ... index(3) of points, one per lane.
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

/// Loads the number at `p`, or the four numbers from `p` on; stores them.
template <class T>
[[gnu::always_inline]] inline T load(const double* p) {
  if constexpr (std::is_same_v<T, double>) {
    return *p;
  } else {
    return T(p, std::experimental::element_aligned);
  }
}
[[gnu::always_inline]] inline void store(double v, double* p) { *p = v; }
[[gnu::always_inline]] inline void store(const Lanes& v, double* p) {
  v.copy_to(p, std::experimental::element_aligned);
}

/// Lanes picked from the eight of a (0 ... 3) and b (4 ... 7).
template <int i, int j, int k, int l>
[[gnu::always_inline]] inline Lanes shuffle(const Lanes& a, const Lanes& b) {
  // TS 2 has no shuffle; these copies are optimized away
  using Row = std::array<double, lane_count>;
  using Register [[gnu::vector_size(sizeof(Row))]] = double;
  Row row;
  Register first, second;
  store(a, row.data());
  std::memcpy(&first, row.data(), sizeof(Row));
  store(b, row.data());
  std::memcpy(&second, row.data(), sizeof(Row));
  const Register picked = __builtin_shufflevector(first, second, i, j, k, l);
  std::memcpy(row.data(), &picked, sizeof(Row));
  return load<Lanes>(row.data());
}

/// Transposes a 4 x 4 table, given and returned by rows.
[[gnu::always_inline]] inline std::array<Lanes, lane_count> transposed(const Lanes& a,
                                                                       const Lanes& b,
                                                                       const Lanes& c,
                                                                       const Lanes& d) {
  const Lanes ab0 = shuffle<0, 4, 2, 6>(a, b), ab1 = shuffle<1, 5, 3, 7>(a, b);
  const Lanes cd0 = shuffle<0, 4, 2, 6>(c, d), cd1 = shuffle<1, 5, 3, 7>(c, d);
  return {shuffle<0, 1, 4, 5>(ab0, cd0), shuffle<0, 1, 4, 5>(ab1, cd1),
          shuffle<2, 3, 6, 7>(ab0, cd0), shuffle<2, 3, 6, 7>(ab1, cd1)};
}

/// Loads column j of points, or columns j ... j + 3 one per lane; stores them.
template <class T>
[[gnu::always_inline]] inline Triple<T> load_columns(const Points& points, Index j) {
  const double* const p = points.data() + 3 * j;
  if constexpr (std::is_same_v<T, double>) {
    return {p[0], p[1], p[2]};
  } else {
    const Lanes a = load<Lanes>(p), b = load<Lanes>(p + 4), c = load<Lanes>(p + 8);
    const Lanes xy = shuffle<0, 1, 6, 7>(a, b);  // x0 y0 x2 y2
    const Lanes zx = shuffle<2, 3, 4, 5>(a, c);  // z0 x1 z2 x3
    const Lanes yz = shuffle<0, 1, 6, 7>(b, c);  // y1 z1 y3 z3
    return {shuffle<0, 5, 2, 7>(xy, zx), shuffle<1, 4, 3, 6>(xy, yz), shuffle<0, 5, 2, 7>(zx, yz)};
  }
}
[[gnu::always_inline]] inline void store_columns(const Triple<double>& v, Points& points, Index j) {
  points.col(j) = vec3(v);
}
[[gnu::always_inline]] inline void store_columns(const Triple<Lanes>& v, Points& points, Index j) {
  double* const p = points.data() + 3 * j;
  const Lanes xy = shuffle<0, 4, 2, 6>(v.x, v.y);
  const Lanes zx = shuffle<0, 5, 2, 7>(v.z, v.x);
  const Lanes yz = shuffle<1, 5, 3, 7>(v.y, v.z);
  store(shuffle<0, 1, 4, 5>(xy, zx), p);
  store(shuffle<0, 1, 6, 7>(yz, xy), p + 4);
  store(shuffle<2, 3, 6, 7>(zx, yz), p + 8);
}

/// Loads quaternion j of a list, or quaternions j ... j + 3 one per lane; stores them.
template <class T>
[[gnu::always_inline]] inline QuatOf<T> load_quats(const Quat* list, Index j) {
  if constexpr (std::is_same_v<T, double>) {
    return quat_of(list[j]);
  } else {
    const auto row = [&](Index k) { return load<Lanes>(list[j + k].coeffs().data()); };
    const auto [x, y, z, w] = transposed(row(0), row(1), row(2), row(3));
    return {w, x, y, z};
  }
}
[[gnu::always_inline]] inline void store_quats(const QuatOf<double>& q, Quat* list, Index j) {
  list[j] = quat(q);
}
[[gnu::always_inline]] inline void store_quats(const QuatOf<Lanes>& q, Quat* list, Index j) {
  const auto rows = transposed(q.x, q.y, q.z, q.w);
  for (int k = 0; k < lane_count; ++k) {
    store(rows[static_cast<std::size_t>(k)], list[j + k].coeffs().data());
  }
}

}  // namespace wirepack
