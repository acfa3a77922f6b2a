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

// With w = m1 - m2 the meeting minimizes |w + s e1 - t e2|^2 + eta |s e1 + t e2|^2, i.e. solves
//   [a11 a12; a12 a22] (s, t) = (b1, b2),
//   a11 = (1 + eta) e1.e1, a12 = -(1 - eta) e1.e2, a22 = (1 + eta) e2.e2, b = (-w.e1, w.e2);
// a free end of line 1 moves s, then t follows from the second row, then a free end of line 2.
struct Meeting {
  Vec3 w;
  double n1, n2, q;          // e1.e1, e2.e2, e1.e2
  double cosine2, parallel;  // squared cosine of the angle; its 4th power, 1 for parallel lines
  double eta;
  double a11, a12, a22, b1, b2, inverse_determinant;
  double s_free, t_free;  // before the ends
  ValueSlope s, t;        // after them
  ValueSlope weight1, weight2;
};

double cube(double x) { return x * x * x; }

std::optional<Meeting> meet(const LineKernel& kernel, const Line& first, const Line& second) {
  const Vec3& e1 = first.vector;
  const Vec3& e2 = second.vector;
  Meeting m;
  m.w = first.midpoint - second.midpoint;
  m.n1 = e1.squaredNorm();
  m.n2 = e2.squaredNorm();
  m.q = e1.dot(e2);
  m.cosine2 = m.q * m.q / (m.n1 * m.n2);
  m.parallel = cube(m.cosine2) * m.cosine2;
  m.eta = kernel.parallel_hold() * m.parallel;
  m.a11 = (1 + m.eta) * m.n1;
  m.a22 = (1 + m.eta) * m.n2;
  m.a12 = (m.eta - 1) * m.q;
  m.inverse_determinant = 1 / (m.a11 * m.a22 - m.a12 * m.a12);
  m.b1 = -m.w.dot(e1);
  m.b2 = m.w.dot(e2);
  m.s_free = (m.a22 * m.b1 - m.a12 * m.b2) * m.inverse_determinant;
  m.weight1 = weight(first, m.s_free);
  if (m.weight1.value <= 0) return std::nullopt;
  m.s = clamp_to_ends(first, m.s_free);
  m.t_free = (m.b2 - m.a12 * m.s.value) / m.a22;
  m.weight2 = weight(second, m.t_free);
  if (m.weight2.value <= 0) return std::nullopt;
  m.t = clamp_to_ends(second, m.t_free);
  return m;
}

}  // namespace

LineKernel LineKernel::per_length(double stiffness, double wire_radius, double edge_length) {
  return {2 * wire_radius, edge_length, stiffness * edge_length / parallel_weight,
          stiffness * 2 * wire_radius};
}

std::optional<LineContact> LineKernel::touch(const Line& first, const Line& second) const {
  const std::optional<Meeting> m = meet(*this, first, second);
  if (!m) return std::nullopt;
  const Vec3 r = m->w + m->s.value * first.vector - m->t.value * second.vector;
  const double distance = r.norm();
  if (distance >= touching_distance) return std::nullopt;
  const double stiffness = m->weight1.value * m->weight2.value * pair_stiffness(m->parallel);
  return LineContact{m->s.value, m->t.value, stiffness, r, distance};
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
  const double k = pair_stiffness(m->parallel);
  const double spring = k / 2 * overlap * overlap;

  // Reverse sweep; x_bar is the derivative of the energy by x. First r and t,
  const Vec3 r_bar = (-k * weight * overlap / distance) * r;
  const double t_bar = spring * m->weight1.value * m->weight2.slope - r_bar.dot(e2) * m->t.slope;
  const double row = t_bar / m->a22;
  double b2_bar = row;
  double a12_bar = -row * s;
  double a22_bar = -row * m->t_free;
  // then s, through the linear system, whose own solution for t is t_linear,
  const double s_bar =
      spring * m->weight1.slope * m->weight2.value + (r_bar.dot(e1) - row * m->a12) * m->s.slope;
  const double t_linear = (m->a11 * m->b2 - m->a12 * m->b1) * m->inverse_determinant;
  const double l1 = m->a22 * m->inverse_determinant * s_bar;
  const double l2 = -m->a12 * m->inverse_determinant * s_bar;
  const double b1_bar = l1;
  b2_bar += l2;
  const double a11_bar = -l1 * m->s_free;
  a12_bar -= l1 * t_linear + l2 * m->s_free;
  a22_bar -= l2 * t_linear;
  // then its entries.
  const double eta_bar = a11_bar * m->n1 + a22_bar * m->n2 + a12_bar * m->q;
  const double parallel_bar =
      eta_bar * parallel_hold() +
      (parallel_stiffness - crossing_stiffness) / 2 * overlap * overlap * weight;
  const double cosine2_bar = parallel_bar * 4 * cube(m->cosine2);
  const double n1_bar = a11_bar * (1 + m->eta) - cosine2_bar * m->cosine2 / m->n1;
  const double n2_bar = a22_bar * (1 + m->eta) - cosine2_bar * m->cosine2 / m->n2;
  const double q_bar = a12_bar * (m->eta - 1) + cosine2_bar * 2 * m->q / (m->n1 * m->n2);

  gradient.midpoint1 = r_bar - b1_bar * e1 + b2_bar * e2;
  gradient.midpoint2 = -gradient.midpoint1;
  gradient.vector1 = s * r_bar + 2 * n1_bar * e1 + q_bar * e2 - b1_bar * m->w;
  gradient.vector2 = -t * r_bar + 2 * n2_bar * e2 + q_bar * e1 + b2_bar * m->w;
  return spring * weight;
}

}  // namespace wirepack
