#pragma once

#include "wirepack/core/lanes.hpp"
#include "wirepack/rod/joint_strain.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

inline const Quat& frame(const RodState& state, Index index) {
  return state.frames[static_cast<std::size_t>(index)];
}

// Without torsion and rest curvature the bending energy is a function of the tangents alone:
// K / 2 |2 t x t' / (1 + t.t')|^2 = 2 K (1 - t.t') / (1 + t.t'), K = YI / l.
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
  const T by_cosine = -4.0 * k * f * f;
  // the cross product keeps the digits that 1 - cosine loses
  return {2.0 * k * dot(normal, normal) * f * f, by_cosine * (after - cosine * before),
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
