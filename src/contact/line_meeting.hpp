#pragma once

#include <cmath>
#include <type_traits>

#include "wirepack/contact/line_contact.hpp"
#include "wirepack/core/lanes.hpp"

namespace wirepack {

// The formulas of the contact kernel, for one pair of lines (T = double) and for four (T = Lanes).
// Always inlined: a call would send some thirty registers through memory (twice the time).

template <class T>
struct ValueSlope {
  T value, slope;
};

template <class T>
struct LineOf {
  Triple<T> midpoint, vector;
  T inverse_n;  // 1 / |vector|^2
};

// A line inside the strand: no end to look after.
struct NoEnd {};
struct FreeEnd {
  bool before, after;
};

// Quadratic B-spline of the parameter of an edge: support +-3/2, sums to one over the edges.
template <class T>
[[gnu::always_inline]] inline ValueSlope<T> spline(const T& s) {
  using std::abs;
  const T u = abs(s);
  const T beyond = u - 1.5;
  const T half = 0.5 * beyond * beyond;
  const T value = select(u <= 0.5, 0.75 - s * s, select(u >= 1.5, T(0.0), half));
  const T slope =
      select(u <= 0.5, -2.0 * s, select(u >= 1.5, T(0.0), select(s > 0.0, beyond, -beyond)));
  return {value, slope};
}

// The last edge of a strand also takes the weights of the edges that are missing beyond its end.
template <class T, class End>
[[gnu::always_inline]] inline ValueSlope<T> weight(const End& end, const T& s) {
  if constexpr (std::is_same_v<End, FreeEnd>) {
    if (end.before && s < 0.5) {
      if (s <= -0.5) return {1, 0};
      return {1 - (s + 0.5) * (s + 0.5) / 2, -(s + 0.5)};
    }
    if (end.after && s > -0.5) {
      if (s >= 0.5) return {1, 0};
      return {1 - (0.5 - s) * (0.5 - s) / 2, 0.5 - s};
    }
  }
  return spline(s);
}

// Beyond a free end the nearest point is the end; rounded off so that the force has no kink.
template <class T, class End>
[[gnu::always_inline]] inline ValueSlope<T> clamp_to_ends(const End& end, const T& s) {
  if constexpr (std::is_same_v<End, FreeEnd>) {
    if (end.before && s < -0.25) {
      if (s <= -0.75) return {-0.5, 0};
      return {-0.5 + (s + 0.75) * (s + 0.75), 2 * (s + 0.75)};
    }
    if (end.after && s > 0.25) {
      if (s >= 0.75) return {0.5, 0};
      return {0.5 - (0.75 - s) * (0.75 - s), 2 * (0.75 - s)};
    }
  }
  return {s, T(1.0)};
}

// With w = m1 - m2 the meeting minimizes |w + s e1 - t e2|^2 + eta |s e1 + t e2|^2, i.e. solves
//   [a11 a12; a12 a22] (s, t) = (b1, b2),
//   a11 = (1 + eta) e1.e1, a12 = -(1 - eta) e1.e2, a22 = (1 + eta) e2.e2, b = (-w.e1, w.e2);
// a free end of line 1 moves s, then t follows from the second row, then a free end of line 2.
// Divisions cost most, so inverses are kept.
template <class T>
struct MeetingSystem {
  Triple<T> w;
  T n1, n2, q;  // e1.e1, e2.e2, e1.e2
  T inverse_n1n2;
  T cosine2, parallel;  // squared cosine of the angle; its 4th power, 1 for parallel lines
  T eta;
  T a11, a12, a22, b1, b2;

  T determinant() const { return a11 * a22 - a12 * a12; }
  // Determinant times s and t.
  T scaled_s() const { return a22 * b1 - a12 * b2; }
  T scaled_t() const { return a11 * b2 - a12 * b1; }
};

template <class T>
struct Meeting : MeetingSystem<T> {
  T inverse_determinant;
  T s_free, t_free;    // before the ends
  ValueSlope<T> s, t;  // after them
  ValueSlope<T> weight1, weight2;
  Triple<T> separation;
  T squared_distance;

  // Overlap within the support of the pair; only then the energy and its gradient mean anything.
  auto touches(const LineKernel& kernel) const {
    const double reach = kernel.touching_distance;
    return squared_distance < reach * reach && weight1.value * weight2.value > 0.0;
  }
};

template <class T>
[[gnu::always_inline]] inline MeetingSystem<T> meeting_system(const LineKernel& kernel,
                                                              const LineOf<T>& first,
                                                              const LineOf<T>& second) {
  const Triple<T>& e1 = first.vector;
  const Triple<T>& e2 = second.vector;
  MeetingSystem<T> m;
  m.w = first.midpoint - second.midpoint;
  m.n1 = dot(e1, e1);
  m.n2 = dot(e2, e2);
  m.q = dot(e1, e2);
  m.inverse_n1n2 = first.inverse_n * second.inverse_n;
  m.cosine2 = m.q * m.q * m.inverse_n1n2;
  m.parallel = m.cosine2 * m.cosine2;
  m.parallel = m.parallel * m.parallel;
  m.eta = kernel.parallel_hold() * m.parallel;
  m.a11 = (1.0 + m.eta) * m.n1;
  m.a22 = (1.0 + m.eta) * m.n2;
  m.a12 = (m.eta - 1.0) * m.q;
  m.b1 = -dot(m.w, e1);
  m.b2 = dot(m.w, e2);
  return m;
}

// Whether lines without ends touch, but for round-off: all by the determinant, so that nothing is
// divided.
template <class T>
[[gnu::always_inline]] inline auto touch_inside(const LineKernel& kernel, const LineOf<T>& first,
                                                const LineOf<T>& second) {
  using std::abs;
  const MeetingSystem<T> m = meeting_system(kernel, first, second);
  const T determinant = m.determinant(), s = m.scaled_s(), t = m.scaled_t();
  const Triple<T> separation = determinant * m.w + s * first.vector - t * second.vector;
  const T reach = kernel.touching_distance * determinant, support = 1.5 * determinant;
  return dot(separation, separation) < reach * reach && abs(s) < support && abs(t) < support;
}

template <class T, class End>
[[gnu::always_inline]] inline Meeting<T> meet(const LineKernel& kernel, const LineOf<T>& first,
                                              const LineOf<T>& second, const End& end1,
                                              const End& end2) {
  const Triple<T>& e1 = first.vector;
  const Triple<T>& e2 = second.vector;
  Meeting<T> m;
  static_cast<MeetingSystem<T>&>(m) = meeting_system(kernel, first, second);
  m.inverse_determinant = 1.0 / m.determinant();
  m.s_free = m.scaled_s() * m.inverse_determinant;
  m.weight1 = weight(end1, m.s_free);
  m.s = clamp_to_ends(end1, m.s_free);
  if constexpr (std::is_same_v<End, NoEnd>) {
    m.t_free = m.scaled_t() * m.inverse_determinant;
  } else {
    m.t_free = (m.b2 - m.a12 * m.s.value) / m.a22;
  }
  m.weight2 = weight(end2, m.t_free);
  m.t = clamp_to_ends(end2, m.t_free);
  m.separation = m.w + m.s.value * e1 - m.t.value * e2;
  m.squared_distance = dot(m.separation, m.separation);
  return m;
}

template <class T>
struct LineGradientOf {
  Triple<T> midpoint1, vector1, midpoint2, vector2;
};

// Energy of a pair that touches, and its gradient.
template <class T>
[[gnu::always_inline]] inline T contact_energy(const LineKernel& kernel, const Meeting<T>& m,
                                               const LineOf<T>& first, const LineOf<T>& second,
                                               LineGradientOf<T>& gradient) {
  using std::sqrt;
  const Triple<T>& e1 = first.vector;
  const Triple<T>& e2 = second.vector;
  const T s = m.s.value;
  const T t = m.t.value;
  const T distance = sqrt(m.squared_distance);
  const T inverse_a22 = 1.0 / m.a22;
  const T overlap = kernel.touching_distance - distance;
  const T pair_weight = m.weight1.value * m.weight2.value;
  const double stiffness_step = kernel.parallel_stiffness - kernel.crossing_stiffness;
  const T k = kernel.pair_stiffness(m.parallel);
  const T spring = 0.5 * k * overlap * overlap;

  // Reverse sweep; x_bar is the derivative of the energy by x. First r and t,
  const Triple<T> r_bar = (-k * pair_weight * overlap / distance) * m.separation;
  const T t_bar = spring * m.weight1.value * m.weight2.slope - dot(r_bar, e2) * m.t.slope;
  const T row = t_bar * inverse_a22;
  T b2_bar = row;
  T a12_bar = -row * s;
  T a22_bar = -row * m.t_free;
  // then s, through the linear system, whose own solution for t is t_linear,
  const T s_bar =
      spring * m.weight1.slope * m.weight2.value + (dot(r_bar, e1) - row * m.a12) * m.s.slope;
  const T t_linear = m.scaled_t() * m.inverse_determinant;
  const T l1 = m.a22 * m.inverse_determinant * s_bar;
  const T l2 = -m.a12 * m.inverse_determinant * s_bar;
  const T b1_bar = l1;
  b2_bar += l2;
  const T a11_bar = -l1 * m.s_free;
  a12_bar -= l1 * t_linear + l2 * m.s_free;
  a22_bar -= l2 * t_linear;
  // then its entries.
  const T eta_bar = a11_bar * m.n1 + a22_bar * m.n2 + a12_bar * m.q;
  const T parallel_bar =
      eta_bar * kernel.parallel_hold() + 0.5 * stiffness_step * overlap * overlap * pair_weight;
  const T cosine2_bar = parallel_bar * 4.0 * m.cosine2 * m.cosine2 * m.cosine2;
  const T over_n1n2 = cosine2_bar * m.inverse_n1n2;
  const T n1_bar = a11_bar * (1.0 + m.eta) - over_n1n2 * m.cosine2 * m.n2;
  const T n2_bar = a22_bar * (1.0 + m.eta) - over_n1n2 * m.cosine2 * m.n1;
  const T q_bar = a12_bar * (m.eta - 1.0) + over_n1n2 * 2.0 * m.q;

  gradient.midpoint1 = r_bar - b1_bar * e1 + b2_bar * e2;
  gradient.midpoint2 = T(-1.0) * gradient.midpoint1;
  gradient.vector1 = s * r_bar + (2.0 * n1_bar) * e1 + q_bar * e2 - b1_bar * m.w;
  gradient.vector2 = (2.0 * n2_bar) * e2 - t * r_bar + q_bar * e1 + b2_bar * m.w;
  return spring * pair_weight;
}

}  // namespace wirepack
