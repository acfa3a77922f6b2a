#include "wirepack/contact/passage.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>

#include "wirepack/contact/segment_distance.hpp"

namespace wirepack {

namespace {

// Proper rotation about the origin that takes `from` nearest to `to` (Kabsch 1976).
Mat3 best_rotation(const Points& from, const Points& to) {
  const Mat3 covariance = to * from.transpose();
  const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double handedness = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  const Vec3 signs(1, 1, handedness < 0 ? -1 : 1);
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

// A point that moves evenly from u = 0 to u = 1.
struct MovingPoint {
  Vec3 start, move;
  Vec3 at(double u) const { return start + u * move; }
};
MovingPoint operator-(const MovingPoint& p, const MovingPoint& q) {
  return {p.start - q.start, p.move - q.move};
}

struct MovingEdge {
  MovingPoint first, last;
  double largest_move() const {
    return std::sqrt(std::max(first.move.squaredNorm(), last.move.squaredNorm()));
  }
};

double distance_at(const MovingEdge& p, const MovingEdge& q, double u) {
  return std::sqrt(
      squared_segment_distance(p.first.at(u), p.last.at(u), q.first.at(u), q.last.at(u)));
}

// c0 + c1 u + c2 u^2 + c3 u^3.
struct Cubic {
  std::array<double, 4> c;
  double operator()(double u) const { return c[0] + u * (c[1] + u * (c[2] + u * c[3])); }
  double largest() const {
    return std::max({std::abs(c[0]), std::abs(c[1]), std::abs(c[2]), std::abs(c[3])});
  }
};

// Volume spanned by both edges and the vector between them: zero when they are coplanar.
Cubic coplanarity(const MovingEdge& p, const MovingEdge& q) {
  const MovingPoint e = p.last - p.first;
  const MovingPoint f = q.last - q.first;
  const MovingPoint w = q.first - p.first;
  const Vec3 n0 = e.start.cross(f.start);
  const Vec3 n1 = e.start.cross(f.move) + e.move.cross(f.start);
  const Vec3 n2 = e.move.cross(f.move);
  return {{n0.dot(w.start), n0.dot(w.move) + n1.dot(w.start), n1.dot(w.move) + n2.dot(w.start),
           n2.dot(w.move)}};
}

// Calls f(u) for every u in [0, 1] where the cubic changes sign; zero counts as positive, so that
// two moves that follow each other never count the same change twice.
template <class F>
void for_each_sign_change(const Cubic& cubic, F&& f) {
  std::array<double, 4> ends{0, 1, 1, 1};  // 0, the extrema inside, 1: monotone in between
  std::size_t count = 1;
  const double a = 3 * cubic.c[3], b = 2 * cubic.c[2], c = cubic.c[1];
  const double discriminant = b * b - 4 * a * c;
  if (discriminant > 0) {
    const double h = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
    std::array<double, 2> extrema{a != 0 ? h / a : -1, h != 0 ? c / h : -1};
    std::sort(extrema.begin(), extrema.end());
    for (const double u : extrema) {
      if (u > 0 && u < 1) ends[count++] = u;
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    double low = ends[k], high = ends[k + 1];
    const bool positive = cubic(low) >= 0;
    if (positive == (cubic(high) >= 0)) continue;
    while (true) {
      const double middle = (low + high) / 2;
      if (middle <= low || middle >= high) break;
      (positive == (cubic(middle) >= 0) ? low : high) = middle;
    }
    f(high);
  }
}

Vec3 nearest_vector(const MovingEdge& p, const MovingEdge& q, double u) {
  // Shortest vector from p to q that starts or ends at a node. Edges in one plane that do not cross
  // have no shorter one.
  const std::array<Vec3, 2> a{p.first.at(u), p.last.at(u)}, b{q.first.at(u), q.last.at(u)};
  const auto to_segment = [](const Vec3& point, const std::array<Vec3, 2>& segment) -> Vec3 {
    const Vec3 d = segment[1] - segment[0];
    const double dd = d.squaredNorm();
    const double s = dd > 0 ? std::clamp((point - segment[0]).dot(d) / dd, 0.0, 1.0) : 0;
    return segment[0] + s * d - point;
  };
  const std::array<Vec3, 4> candidates{to_segment(a[0], b), to_segment(a[1], b),
                                       -to_segment(b[0], a), -to_segment(b[1], a)};
  return *std::min_element(candidates.begin(), candidates.end(), [](const Vec3& x, const Vec3& y) {
    return x.squaredNorm() < y.squaredNorm();
  });
}

// Time at which edges meet that share a plane all the time, as parallel strands do: a node of one
// then meets the other edge.
std::optional<double> meeting_in_plane(const MovingEdge& p, const MovingEdge& q, double tolerance) {
  const Vec3 before = nearest_vector(p, q, 0);
  if (before.norm() <= tolerance || before.dot(nearest_vector(p, q, 1)) > 0) return std::nullopt;
  std::optional<double> found;
  const auto node_meets = [&](const MovingPoint& node, const MovingEdge& edge) {
    const MovingPoint d = node - edge.first;
    const MovingPoint e = edge.last - edge.first;
    const Vec3 c0 = d.start.cross(e.start);
    const Vec3 c1 = d.start.cross(e.move) + d.move.cross(e.start);
    const Vec3 c2 = d.move.cross(e.move);
    for (int k = 0; k < 3; ++k) {
      for_each_sign_change(Cubic{{c0[k], c1[k], c2[k], 0}}, [&](double u) {
        if (!found && distance_at(p, q, u) <= tolerance) found = u;
      });
    }
  };
  node_meets(p.first, q);
  node_meets(p.last, q);
  node_meets(q.first, p);
  node_meets(q.last, p);
  return found;
}

struct Passing {
  double time;
  Vec3 place;
};

// Time and place of the last passage, if the edges pass each other an odd number of times.
std::optional<Passing> passing(const MovingEdge& p, const MovingEdge& q) {
  const auto length = [](const MovingEdge& e) {
    const MovingPoint d = e.last - e.first;
    return d.start.norm() + d.move.norm();
  };
  const MovingPoint w = q.first - p.first;
  const double p_length = length(p), q_length = length(q);
  const double tolerance = 1e-6 * (p_length + q_length);
  const Cubic volume = coplanarity(p, q);
  const double scale = p_length * q_length * (w.start.norm() + w.move.norm());
  if (volume.largest() <= 1e-9 * scale) {
    const auto time = meeting_in_plane(p, q, tolerance);
    if (!time) return std::nullopt;
    return Passing{*time, p.first.at(*time)};
  }
  int passages = 0;
  double last = 0;
  for_each_sign_change(volume, [&](double u) {
    if (distance_at(p, q, u) > tolerance) return;
    ++passages;
    last = u;
  });
  if (passages % 2 == 0) return std::nullopt;
  const Vec3 a = p.first.at(last), b = q.first.at(last);
  const Vec3 e = p.last.at(last) - a, f = q.last.at(last) - b;
  const Vec3 normal = e.cross(f);
  const double s = (b - a).cross(f).dot(normal) / normal.squaredNorm();
  return Passing{last, a + std::clamp(s, 0.0, 1.0) * e};
}

// Calls f for pairs of edges whose boxes overlap. A box holds all that its edge sweeps over. Boxes
// are sorted along the longest side of the whole.
template <class F>
void for_each_near_pair(const std::vector<MovingEdge>& edges, F&& f) {
  const auto count = static_cast<Index>(edges.size());
  Points low(3, count), high(3, count);
  for (Index j = 0; j < count; ++j) {
    const MovingEdge& e = edges[static_cast<std::size_t>(j)];
    const Vec3 first = e.first.at(1), last = e.last.at(1);
    const double rounding = 1e-6 * (e.first.start - e.last.start).norm();
    low.col(j) =
        e.first.start.cwiseMin(e.last.start).cwiseMin(first).cwiseMin(last).array() - rounding;
    high.col(j) =
        e.first.start.cwiseMax(e.last.start).cwiseMax(first).cwiseMax(last).array() + rounding;
  }
  Index axis = 0;
  (high.rowwise().maxCoeff() - low.rowwise().minCoeff()).maxCoeff(&axis);
  std::vector<Index> order(edges.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index i, Index j) {
    return low(axis, i) < low(axis, j) || (low(axis, i) == low(axis, j) && i < j);
  });
  for (auto first = order.begin(); first != order.end(); ++first) {
    for (auto second = first + 1; second != order.end(); ++second) {
      if (low(axis, *second) > high(axis, *first)) break;
      const bool apart = (low.col(*first).array() > high.col(*second).array()).any() ||
                         (low.col(*second).array() > high.col(*first).array()).any();
      if (!apart) f(std::min(*first, *second), std::max(*first, *second));
    }
  }
}

}  // namespace

std::vector<EdgePair> passed_pairs(const RodState& before, const RodState& after,
                                   Index separation) {
  assert(separation >= 2 && before.ends.closed == after.ends.closed);
  assert(!before.ends.closed || before.node_count() == after.node_count());
  const Index nodes = std::min(before.node_count(), after.node_count());
  const bool closed = before.ends.closed;
  const Points start = before.nodes.leftCols(nodes);
  const Points end =
      best_rotation(after.nodes.leftCols(nodes), start) * after.nodes.leftCols(nodes);
  const Index edge_count = closed ? nodes : nodes - 1;
  std::vector<MovingEdge> edges;
  edges.reserve(static_cast<std::size_t>(edge_count));
  const auto point = [&](Index i) { return MovingPoint{start.col(i), end.col(i) - start.col(i)}; };
  for (Index j = 0; j < edge_count; ++j) edges.push_back({point(j), point((j + 1) % nodes)});

  struct Hit {
    EdgePair pair;
    Passing passing;
  };
  std::vector<Hit> hits;
  for_each_near_pair(edges, [&](Index j, Index k) {
    if (k - j < separation || (closed && j + edge_count - k < separation)) return;
    const MovingEdge& p = edges[static_cast<std::size_t>(j)];
    const MovingEdge& q = edges[static_cast<std::size_t>(k)];
    if (distance_at(p, q, 0) > p.largest_move() + q.largest_move()) return;
    if (const auto found = passing(p, q)) hits.push_back({{j, k}, *found});
  });
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return a.pair.first != b.pair.first ? a.pair.first < b.pair.first
                                        : a.pair.second < b.pair.second;
  });

  // A hit on a node is seen by both edges that meet there, at the same time and place.
  std::vector<Hit> kept;
  const auto edge_length = [&](Index j) {
    return (start.col((j + 1) % nodes) - start.col(j)).norm();
  };
  const auto neighbours = [&](Index i, Index j) {
    const Index apart = std::abs(i - j);
    return apart <= 1 || (closed && apart == edge_count - 1);
  };
  for (const Hit& hit : hits) {
    const bool seen = std::any_of(kept.begin(), kept.end(), [&](const Hit& other) {
      return std::abs(hit.passing.time - other.passing.time) < 1e-5 &&
             (hit.passing.place - other.passing.place).norm() <
                 1e-5 * edge_length(hit.pair.first) &&
             neighbours(hit.pair.first, other.pair.first) &&
             neighbours(hit.pair.second, other.pair.second);
    });
    if (!seen) kept.push_back(hit);
  }
  std::vector<EdgePair> pairs;
  pairs.reserve(kept.size());
  for (const Hit& hit : kept) pairs.push_back(hit.pair);
  return pairs;
}

}  // namespace wirepack
