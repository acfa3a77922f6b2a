#include "wirepack/contact/line_contact.hpp"

#include <cmath>

namespace wirepack {

namespace {

struct ValueSlope {
  double value, slope;
};

// Quadratic B-spline of the parameter of an edge: support +-3/2, sums to one over the edges.
ValueSlope spline(double s) {
  const double u = std::abs(s);
  if (u <= 0.5) return {0.75 - s * s, -2 * s};
  if (u >= 1.5) return {0, 0};
  const double slope = u - 1.5;
  return {slope * slope / 2, s > 0 ? slope : -slope};
}

// The last edge of a strand also takes the weights of the edges that are missing beyond its end.
ValueSlope weight(const Line& line, double s) {
  if (line.ends_before && s < 0.5) {
    if (s <= -0.5) return {1, 0};
    return {1 - (s + 0.5) * (s + 0.5) / 2, -(s + 0.5)};
  }
  if (line.ends_after && s > -0.5) {
    if (s >= 0.5) return {1, 0};
    return {1 - (0.5 - s) * (0.5 - s) / 2, 0.5 - s};
  }
  return spline(s);
}

// Beyond a free end the nearest point is the end; rounded off so that the force has no kink.
ValueSlope clamp_to_ends(const Line& line, double s) {
  if (line.ends_before && s < -0.25) {
    if (s <= -0.75) return {-0.5, 0};
    return {-0.5 + (s + 0.75) * (s + 0.75), 2 * (s + 0.75)};
  }
  if (line.ends_after && s > 0.25) {
    if (s >= 0.75) return {0.5, 0};
    return {0.5 - (0.75 - s) * (0.75 - s), 2 * (0.75 - s)};
  }
  return {s, 1};
}

// With w = m1 - m2 the regularised nearest points solve
//   [a11 a12; a12 a22] (s, t) = (-w.e1, w.e2),  a11 = e1.e1 + eps l^2, a12 = -e1.e2, a22 likewise;
// a free end of line 1 moves s, then t follows from the second row, then a free end of line 2.
struct Meeting {
  Vec3 w;
  double a11, a12, a22, inverse_determinant;
  double s_free, t_free;  // before the ends
  ValueSlope s, t;        // after them
  ValueSlope weight1, weight2;
};

std::optional<Meeting> meet(const LineKernel& kernel, const Line& first, const Line& second) {
  const Vec3& e1 = first.vector;
  const Vec3& e2 = second.vector;
  const double eps = LineKernel::regularisation * kernel.edge_length * kernel.edge_length;
  Meeting m;
  m.w = first.midpoint - second.midpoint;
  m.a11 = e1.squaredNorm() + eps;
  m.a22 = e2.squaredNorm() + eps;
  m.a12 = -e1.dot(e2);
  m.inverse_determinant = 1 / (m.a11 * m.a22 - m.a12 * m.a12);
  const double b1 = -m.w.dot(e1);
  const double b2 = m.w.dot(e2);
  m.s_free = (m.a22 * b1 - m.a12 * b2) * m.inverse_determinant;
  m.weight1 = weight(first, m.s_free);
  if (m.weight1.value <= 0) return std::nullopt;
  m.s = clamp_to_ends(first, m.s_free);
  m.t_free = (b2 - m.a12 * m.s.value) / m.a22;
  m.weight2 = weight(second, m.t_free);
  if (m.weight2.value <= 0) return std::nullopt;
  m.t = clamp_to_ends(second, m.t_free);
  return m;
}

}  // namespace

std::optional<LineContact> LineKernel::touch(const Line& first, const Line& second) const {
  const std::optional<Meeting> m = meet(*this, first, second);
  if (!m) return std::nullopt;
  const Vec3 r = m->w + m->s.value * first.vector - m->t.value * second.vector;
  const double distance = r.norm();
  if (distance >= touching_distance) return std::nullopt;
  return LineContact{m->s.value, m->t.value, m->weight1.value * m->weight2.value, r, distance};
}

double LineKernel::energy(const Line& first, const Line& second, LineGradient& gradient) const {
  const std::optional<Meeting> m = meet(*this, first, second);
  if (!m) return 0;
  const Vec3& e1 = first.vector;
  const Vec3& e2 = second.vector;
  const double s = m->s.value;
  const double t = m->t.value;
  const Vec3 r = m->w + s * e1 - t * e2;
  const double squared = r.squaredNorm();
  if (squared >= touching_distance * touching_distance) return 0;
  const double distance = std::sqrt(squared);
  const double overlap = touching_distance - distance;
  const double weight = m->weight1.value * m->weight2.value;
  const double spring = stiffness / 2 * overlap * overlap;

  // Reverse sweep: r, then t (clamped, free), then s (clamped, free), then the 2 x 2 system.
  const Vec3 by_r = (-stiffness * weight * overlap / distance) * r;
  const double by_t_free = spring * m->weight1.value * m->weight2.slope - by_r.dot(e2) * m->t.slope;
  const double through_t = by_t_free / m->a22;  // t_free = (w.e2 + s e1.e2) / a22
  const double by_s = by_r.dot(e1) - through_t * m->a12;
  const double by_s_free = spring * m->weight1.slope * m->weight2.value + by_s * m->s.slope;
  const double l1 = m->a22 * m->inverse_determinant * by_s_free;
  const double l2 = -m->a12 * m->inverse_determinant * by_s_free;
  // the system's own solution for t, which goes with s_free inside the linear solve
  const double t0 = (m->a11 * m->w.dot(e2) + m->a12 * m->w.dot(e1)) * m->inverse_determinant;
  const double s0 = m->s_free;
  const double t1 = m->t_free;

  const Vec3 by_w = by_r - l1 * e1 + (l2 + through_t) * e2;
  gradient.midpoint1 = by_w;
  gradient.midpoint2 = -by_w;
  gradient.vector1 =
      s * by_r + l1 * (t0 * e2 - m->w - 2 * s0 * e1) + (l2 * s0 + through_t * s) * e2;
  gradient.vector2 = -t * by_r + (l1 * t0 + through_t * s) * e1 +
                     l2 * (m->w + s0 * e1 - 2 * t0 * e2) + through_t * (m->w - 2 * t1 * e2);
  return spring * weight;
}

}  // namespace wirepack
