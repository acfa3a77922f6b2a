#pragma once

#include <cmath>

#include "wirepack/core/arctangent.hpp"
#include "wirepack/core/lanes.hpp"
#include "wirepack/core/types.hpp"

namespace wirepack {

/// Integrated strain of a joint: bending (k1, k2) l and twist k3 l, dimensionless, and its
/// derivative by the relative spin of the two frames, both seen from the frame `before`:
/// d(value_k) = by_spin_k . R_before^T (spin_after - spin_before).
/// For one joint or for four (Lanes).
template <class T>
struct JointStrainOf {
  Triple<T> value;
  Triple<T> bend1_by_spin, bend2_by_spin, twist_by_spin;
};

/// Strain from the relative quaternion p = conj(q_before) q_after = (w, x, y, z). This is half of
/// the twist, a turn of the tangent by an angle, and the other half of the twist. Bending is the
/// vector 2 (x, y) sqrt((2 + 1 / c^2) / 3) in the frame half-way through the twist,
/// c^2 = w^2 + z^2 = cos^2(angle / 2), s^2 = x^2 + y^2 = sin^2(angle / 2); twist is 2 atan2(z, w).
/// Bending is thus independent of the relative twist. (Averaged directors of the two edges depend
/// on the twist, and open a hinge.) The square of its length is
///     2/3 (2 s)^2 + 1/3 (2 s / c)^2 = angle^2 (1 + 7/720 angle^4 + ...),
/// in which the first errors of chord and tangent cancel. So it is that of the turning angle, which
/// is exact on arcs, but for 1 % at a radian; and it grows without bound towards a turn of pi.
///
/// `twist_guide` picks the whole turns: the twist returned is within pi of it. p and -p are the
/// same rotation. The one with the returned twist is taken, up to full cycles of 4 pi, so the
/// half-way frame in which bending is measured turns continuously with the twist.
template <class T>
[[gnu::always_inline]] inline JointStrainOf<T> joint_strain(const QuatOf<T>& before,
                                                            const QuatOf<T>& after,
                                                            const T& twist_guide) {
  using std::floor, std::sqrt;
  const QuatOf<T> p = before.conjugate() * after;
  const T half_turn = select(p.w < 0.0, T(-1.0), T(1.0));  // makes the twist at most pi
  const T raw = 2.0 * arctangent(half_turn * p.z, half_turn * p.w);
  const T turns = floor((twist_guide - raw) / (2 * pi) + 0.5);
  const T sign = select(floor(0.5 * turns) == 0.5 * turns, half_turn, -half_turn);
  const T w = sign * p.w, x = sign * p.x, y = sign * p.y, z = sign * p.z;

  // dp = 1/2 (0, spin) p, spin in the frame `before`
  const T inverse_c2 = 1.0 / (w * w + z * z);
  const T square = inverse_c2 + 2.0;
  const T scale = sqrt((1.0 / 3) * square);
  const T a = (z * y - w * x) * inverse_c2;  // d log(w^2 + z^2) = (a, b, 0) . spin
  const T b = -(z * x + w * y) * inverse_c2;
  const T share = inverse_c2 / square;  // d log(scale^2) = -share (a, b, 0) . spin
  const T scaled_a = share * a, scaled_b = share * b;
  return {{2.0 * scale * x, 2.0 * scale * y, raw + (2 * pi) * turns},
          scale * Triple<T>{w - x * scaled_a, z - x * scaled_b, -y},
          scale * Triple<T>{-z - y * scaled_a, w - y * scaled_b, x},
          {-b, a, T(1.0)}};
}

}  // namespace wirepack
