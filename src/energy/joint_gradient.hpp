#pragma once

#include "wirepack/core/lanes.hpp"
#include "wirepack/rod/joint_strain.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

inline const Quat& frame(const RodState& state, Index index) {
  return state.frames[static_cast<std::size_t>(index)];
}

// Without torsion and rest curvature the bending energy is a function of the tangents alone, K / 2
// times the square of the length of the bending strain (joint_strain.hpp), K = YI / l:
// 2/3 K (1 - t.t') (1 + 1 / (1 + t.t')).
template <class T>
struct TangentBending {
  T energy;
  Triple<T> by_before, by_after;  // each normal to its tangent
};

template <class T>
[[gnu::always_inline]] inline TangentBending<T> tangent_bending(const Triple<T>& before,
                                                                const Triple<T>& after,
                                                                const T& k) {
  const T cosine = dot(before, after);
  const Triple<T> normal = cross(before, after);
  const T f = 1.0 / (1.0 + cosine);
  const T two_thirds = (2.0 / 3) * k;
  const T by_cosine = -two_thirds * (1.0 + 2.0 * f * f);
  // 1 - cosine; the cross product keeps the digits that it loses
  const T q = dot(normal, normal) * f;
  return {two_thirds * q * (1.0 + f), by_cosine * (after - cosine * before),
          by_cosine * (before - cosine * after)};
}

// Energy of a joint of this length, and its derivative by the spin of the frame behind it, which is
// minus that by the frame before it.
template <class T>
struct JointGradient {
  T energy;
  Triple<T> moment, by_spin;
};

template <class T>
[[gnu::always_inline]] inline JointGradient<T> joint_gradient(const QuatOf<T>& before,
                                                              const QuatOf<T>& after,
                                                              const T& guide, const Triple<T>& rest,
                                                              const Vec3& stiffness,
                                                              double length) {
  const JointStrainOf<T> strain = joint_strain(before, after, guide);
  const Triple<T> excess = strain.value - rest;
  const Vec3 k = stiffness / length;
  const Triple<T> moment{k.x() * excess.x, k.y() * excess.y, k.z() * excess.z};
  return {0.5 * dot(moment, excess), moment,
          before * (moment.x * strain.bend1_by_spin + moment.y * strain.bend2_by_spin +
                    moment.z * strain.twist_by_spin)};
}

}  // namespace wirepack
