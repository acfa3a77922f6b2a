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
/// the twist, a turn of the tangent, and the other half of the twist. Bending is
/// 2 (x, y) / sqrt(w^2 + z^2) in the frame half-way through the twist, of length 2 tan(angle / 2);
/// twist is 2 atan2(z, w). Bending is thus independent of the relative twist, and grows without
/// bound towards a turn of pi. (Averaged directors of the two edges depend on the twist, and open
/// a hinge.)
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
  const T scale = sqrt(inverse_c2);
  const T a = (z * y - w * x) * inverse_c2;  // d log(w^2 + z^2) = (a, b, 0) . spin
  const T b = -(z * x + w * y) * inverse_c2;
  return {{2.0 * scale * x, 2.0 * scale * y, raw + (2 * pi) * turns},
          scale * Triple<T>{w - x * a, z - x * b, -y},
          scale * Triple<T>{-z - y * a, w - y * b, x},
          {-b, a, T(1.0)}};
}

}  // namespace wirepack
