#pragma once

#include <Eigen/Core>
#include <cmath>

namespace wirepack {

/// Pose relative to another: directors as columns, place of the centreline.
template <class T>
struct Placement {
  Eigen::Matrix<T, 3, 3> rotation;
  Eigen::Matrix<T, 3, 1> position;
};

/// The centreline and frame at arc s of a rod whose Darboux vector k is constant, seen from those
/// at arc 0: the exponential of a screw, R = exp(s [k]x), position = int_0^s R(u) e3 du. For any
/// sign of s; T is a number or a jet of derivatives.
template <class T>
Placement<T> screw_motion(const Eigen::Matrix<T, 3, 1>& k, const T& s) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const T x = s * s * k.squaredNorm();  // square of the angle
  // sin(a) / a, (1 - cos a) / a^2 and (a - sin a) / a^3 with a^2 = x
  T f1, f2, f3;
  if (x < T(1)) {  // series; the root has no derivative at 0
    T term(1);     // (-x)^n / (2 n + 1)!
    f1 = f2 = f3 = T(0);
    for (int n = 0; n < 11; ++n) {
      f1 += term;
      f2 += term / T(2 * n + 2);
      f3 += term / T((2 * n + 2) * (2 * n + 3));
      term *= -x / T((2 * n + 2) * (2 * n + 3));
    }
  } else {
    const T angle = sqrt(x);
    const T half = sin(angle / T(2));
    f1 = sin(angle) / angle;
    f2 = T(2) * half * half / x;
    f3 = (angle - sin(angle)) / (x * angle);
  }
  Eigen::Matrix<T, 3, 3> cross;
  cross << T(0), -k.z(), k.y(), k.z(), T(0), -k.x(), -k.y(), k.x(), T(0);
  const Eigen::Matrix<T, 3, 3> square = cross * cross;
  Placement<T> result;
  result.rotation = Eigen::Matrix<T, 3, 3>::Identity() + s * f1 * cross + s * s * f2 * square;
  result.position = s * s * f2 * cross.col(2) + s * s * s * f3 * square.col(2);
  result.position.z() += s;
  return result;
}

}  // namespace wirepack
