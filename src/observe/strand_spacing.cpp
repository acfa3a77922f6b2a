#include "wirepack/observe/strand_spacing.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "wirepack/core/rotation.hpp"

namespace wirepack {

namespace {

constexpr double steep = 0.7;
constexpr double first_shell = 1.5;  // the second shell of a hexagonal lattice is at sqrt(3)
constexpr double infinity = std::numeric_limits<double>::infinity();

using Vec2 = Eigen::Vector2d;

/// Where strands pass a plane, in its own axes.
struct Section {
  Eigen::Matrix2Xd points;
  Points tangents;
};

Section section(const RodState& state, const Vec3& normal) {
  const Quat to_plane = frame_with_tangent(normal).conjugate();
  std::vector<Vec2> found;
  std::vector<Vec3> tangents;
  for (Index j = 0; j < state.edge_count(); ++j) {
    const Vec3 a = to_plane * Vec3(state.nodes.col(j));
    const Vec3 b = to_plane * Vec3(state.nodes.col(next_node(state, j)));
    if ((a.z() < 0) == (b.z() < 0)) continue;
    const Vec3 e = b - a;
    if (std::abs(e.z()) <= steep * e.norm()) continue;
    found.push_back((a - a.z() / e.z() * e).head<2>());
    tangents.push_back(e.normalized() * (e.z() > 0 ? 1 : -1));
  }
  Section cut{Eigen::Matrix2Xd(2, static_cast<Index>(found.size())),
              Points(3, static_cast<Index>(found.size()))};
  for (Index i = 0; i < cut.points.cols(); ++i) {
    cut.points.col(i) = found[static_cast<std::size_t>(i)];
    cut.tangents.col(i) = tangents[static_cast<std::size_t>(i)];
  }
  return cut;
}

// Two points share an edge of the Delaunay triangulation when a circle through both has no other
// one inside: when an interval of places of its centre, on the line half-way between them, is left.
bool is_delaunay_edge(const Eigen::Matrix2Xd& p, Index i, Index j) {
  const Vec2 middle = (p.col(i) + p.col(j)) / 2, half = (p.col(j) - p.col(i)) / 2;
  const Vec2 normal = Vec2(-half.y(), half.x()).normalized();
  double low = -infinity, high = infinity;
  for (Index k = 0; k < p.cols(); ++k) {
    if (k == i || k == j) continue;
    const Vec2 d = p.col(k) - middle;
    const double side = d.dot(normal), excess = d.squaredNorm() - half.squaredNorm();
    if (std::abs(side) < 1e-9 * half.norm()) {
      if (excess < 0) return false;  // between them
      continue;
    }
    (side > 0 ? high : low) =
        side > 0 ? std::min(high, excess / (2 * side)) : std::max(low, excess / (2 * side));
  }
  const bool alone = low == -infinity && high == infinity;
  return !alone && low <= high + 1e-9 * half.norm();
}

struct Neighbours {
  Index first, second;
};

std::vector<Neighbours> neighbours(const Eigen::Matrix2Xd& points) {
  const Index n = points.cols();
  Eigen::VectorXd nearest(n);
  for (Index i = 0; i < n; ++i) {
    Eigen::VectorXd distances = (points.colwise() - points.col(i)).colwise().norm();
    distances[i] = infinity;
    nearest[i] = distances.minCoeff();
  }
  std::vector<Neighbours> result;
  for (Index i = 0; i < n; ++i) {
    for (Index j = i + 1; j < n; ++j) {
      const double distance = (points.col(i) - points.col(j)).norm();
      if (distance > first_shell * std::max(nearest[i], nearest[j])) continue;
      if (is_delaunay_edge(points, i, j)) result.push_back({i, j});
    }
  }
  return result;
}

// Adds the sums, not the means.
void add_spacing(const Section& cut, StrandSpacing& sums) {
  const Index n = cut.points.cols();
  std::vector<std::complex<double>> order(static_cast<std::size_t>(n));
  std::vector<int> count(static_cast<std::size_t>(n), 0);
  const auto see = [&](Index from, const Vec3& to) {
    const Quat frame = frame_with_tangent(cut.tangents.col(from));
    const Vec3 across = frame.conjugate() * to;
    order[static_cast<std::size_t>(from)] +=
        std::polar(1.0, 6 * std::atan2(across.y(), across.x()));
    ++count[static_cast<std::size_t>(from)];
  };
  for (const auto& [i, j] : neighbours(cut.points)) {
    Vec3 to(0, 0, 0);
    to.head<2>() = cut.points.col(j) - cut.points.col(i);
    const Vec3 along = (cut.tangents.col(i) + cut.tangents.col(j)).normalized();
    sums.mean += to.norm();
    sums.across += (to - to.dot(along) * along).norm();
    ++sums.pairs;
    see(i, to);
    see(j, -to);
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (count[i] < 3) continue;
    sums.hexagonal_order += std::abs(order[i]) / count[i];
    ++sums.ordered;
  }
}

StrandSpacing means(StrandSpacing sums) {
  if (sums.pairs > 0) {
    sums.mean /= static_cast<double>(sums.pairs);
    sums.across /= static_cast<double>(sums.pairs);
  }
  if (sums.ordered > 0) sums.hexagonal_order /= static_cast<double>(sums.ordered);
  return sums;
}

}  // namespace

StrandSpacing delaunay_spacing(const Eigen::Matrix2Xd& points) {
  StrandSpacing sums;
  add_spacing({points, Vec3::UnitZ().replicate(1, points.cols())}, sums);
  return means(sums);
}

StrandSpacing strand_spacing(const RodState& state, const Points& normals) {
  StrandSpacing sums;
  for (Index k = 0; k < normals.cols(); ++k) {
    add_spacing(section(state, normals.col(k).normalized()), sums);
  }
  return means(sums);
}

StrandSpacing strand_spacing(const RodState& state) {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  Points normals(3, 6);
  normals << 0, 0, 1, -1, golden, golden,  //
      1, -1, golden, golden, 0, 0,         //
      golden, golden, 0, 0, 1, -1;
  return strand_spacing(state, normals);
}

}  // namespace wirepack
