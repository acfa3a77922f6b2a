#include "wirepack/observe/writhe.hpp"

#include <cassert>
#include <cmath>
#include <complex>
#include <vector>

#include "wirepack/core/threads.hpp"
#include "wirepack/rod/rod_strain.hpp"

namespace wirepack {

namespace {

// Solid angle of the directions from points of p0 p1 to points of q0 q1, positive for a
// right-handed crossing, as two spherical triangles c b a and d c a: for unit vectors a, b, c
// tan(angle / 2) = a.(b x c) / (1 + a.b + b.c + c.a) (van Oosterom & Strackee 1983).
double solid_angle(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
  const Vec3 a = (q0 - p0).normalized(), b = (q1 - p0).normalized();
  const Vec3 c = (q1 - p1).normalized(), d = (q0 - p1).normalized();
  const double ac = a.dot(c);
  const Vec3 axc = a.cross(c);
  const std::complex<double> first(1 + a.dot(b) + b.dot(c) + ac, axc.dot(b));
  const std::complex<double> second(1 + ac + c.dot(d) + d.dot(a), -axc.dot(d));
  return 2 * std::arg(first * second);
}

}  // namespace

CrossingSums crossing_sums(const Points& nodes, bool closed) {
  const Index n = nodes.cols();
  const Index edges = closed ? n : n - 1;
  std::vector<CrossingSums> of_edge(static_cast<std::size_t>(edges));  // with later ones
  for_each_tile(edges, 16, true, [&](Index start, Index end) {
    for (Index i = start; i < end; ++i) {
      const Vec3 p0 = nodes.col(i), p1 = nodes.col((i + 1) % n);
      CrossingSums& sums = of_edge[static_cast<std::size_t>(i)];
      for (Index j = i + 2; j < edges; ++j) {
        if (closed && i == 0 && j == edges - 1) continue;  // neighbours span no angle
        const double angle = solid_angle(p0, p1, nodes.col(j), nodes.col((j + 1) % n));
        sums.writhe += angle / (2 * pi);
        sums.average_crossing_number += std::abs(angle) / (2 * pi);
      }
    }
  });
  CrossingSums total;
  for (const CrossingSums& sums : of_edge) {
    total.writhe += sums.writhe;
    total.average_crossing_number += sums.average_crossing_number;
  }
  return total;
}

double writhe(const Points& nodes, bool closed) { return crossing_sums(nodes, closed).writhe; }

double writhe(const RodState& state) { return writhe(state.nodes, state.ends.closed); }

double linking_number(const Points& first, const Points& second) {
  double sum = 0;
  for (Index i = 0; i < first.cols(); ++i) {
    const Vec3 p0 = first.col(i), p1 = first.col((i + 1) % first.cols());
    for (Index j = 0; j < second.cols(); ++j) {
      sum += solid_angle(p0, p1, second.col(j), second.col((j + 1) % second.cols()));
    }
  }
  return sum / (4 * pi);
}

double total_twist(const RodState& state) {
  const std::vector<double> twists = joint_twists(state);
  double sum = 0;
  for_each_joint(state,
                 [&](const Joint& joint) { sum += twists[static_cast<std::size_t>(joint.node)]; });
  return sum / (2 * pi);
}

Points ribbon_edge(const RodState& state, double distance) {
  assert(state.ends.closed);
  Points edge = state.nodes;
  for_each_joint(state, [&](const Joint& joint) {
    Quat before = state.frames[static_cast<std::size_t>(joint.before)];
    const Quat& after = state.frames[static_cast<std::size_t>(joint.after)];
    if (before.dot(after) < 0) before.coeffs() *= -1;
    const Quat half_way(Eigen::Vector4d((before.coeffs() + after.coeffs()).normalized()));
    edge.col(joint.node) += distance * (half_way * Vec3::UnitX());
  });
  return edge;
}

}  // namespace wirepack
