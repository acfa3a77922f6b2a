#pragma once

#include "wirepack/core/lanes.hpp"
#include "wirepack/core/types.hpp"

namespace wirepack {

/// atan2(y, x) for x >= 0, to three units in the last place; for a number or for lanes, without
/// branches. Undefined at (0, 0).
template <class T>
[[gnu::always_inline]] inline T arctangent(const T& y, const T& x) {
  // Reduced to ratios |u| <= tan(pi / 8) by atan(1 / r) = pi / 2 - atan(r) and
  // atan(r) = pi / 4 + atan((r - 1) / (r + 1)).
  const T size = select(y < 0.0, -y, y);
  const auto is_steep = size > x;
  const T low = select(is_steep, x, size);
  const T high = select(is_steep, size, x);
  const auto is_middle = low > 0.41421356237309503 * high;
  const T u = select(is_middle, low - high, low) / select(is_middle, low + high, high);
  // atan(u) = u + u s P(s), s = u^2; Chebyshev interpolation of P, error 5e-18 of s P
  const T s = u * u, s2 = s * s;
  const T even = -0x1.5555555555555p-2 +
                 s2 * (-0x1.24924924360cbp-3 +
                       s2 * (-0x1.745d0b26b83e7p-4 +
                             s2 * (-0x1.10fa75382537fp-4 +
                                   s2 * (-0x1.a098bb6ba4941p-5 - s2 * 0x1.3a2b7a07caea8p-6))));
  const T odd =
      0x1.999999999934ap-3 +
      s2 * (0x1.c71c7185314cbp-4 +
            s2 * (0x1.3b1262d95579ep-4 + s2 * (0x1.dfe61e80903d2p-5 + s2 * 0x1.41603647c7a7cp-5)));
  const T small = u + u * (s * (even + s * odd));
  const T flat = select(is_middle, pi / 4 + small, small);
  const T angle = select(is_steep, pi / 2 - flat, flat);
  return select(y < 0.0, -angle, angle);
}

}  // namespace wirepack
