#include "wirepack/observe/strand_spacing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "wirepack/core/rotation.hpp"

namespace wirepack {

namespace {

constexpr double steep = 0.7;
constexpr double first_shell = 1.5;  // the second shell of a hexagonal lattice is at sqrt(3)

using Vec2 = Eigen::Vector2d;

Eigen::Matrix2Xd crossings(const RodState& state, const Vec3& normal) {
  const Quat to_plane = frame_with_tangent(normal).conjugate();
  std::vector<Vec2> found;
  for (Index j = 0; j < state.edge_count(); ++j) {
    const Vec3 a = to_plane * Vec3(state.nodes.col(j));
    const Vec3 b = to_plane * Vec3(state.nodes.col(next_node(state, j)));
    if ((a.z() < 0) == (b.z() < 0)) continue;
    const Vec3 e = b - a;
    if (std::abs(e.z()) <= steep * e.norm()) continue;
    found.push_back((a - a.z() / e.z() * e).head<2>());
  }
  Eigen::Matrix2Xd points(2, static_cast<Index>(found.size()));
  for (Index i = 0; i < points.cols(); ++i) points.col(i) = found[static_cast<std::size_t>(i)];
  return points;
}

// Whether no other point lies inside the circle through three.
bool is_delaunay(const Eigen::Matrix2Xd& p, Index i, Index j, Index k) {
  const Vec2 b = p.col(j) - p.col(i), c = p.col(k) - p.col(i);
  const double twice_area = b.x() * c.y() - b.y() * c.x();
  if (std::abs(twice_area) < 1e-9 * (b.squaredNorm() + c.squaredNorm())) return false;
  const Vec2 centre = Vec2(c.y() * b.squaredNorm() - b.y() * c.squaredNorm(),
                           b.x() * c.squaredNorm() - c.x() * b.squaredNorm()) /
                      (2 * twice_area);
  const double square = centre.squaredNorm() * (1 - 1e-9);
  for (Index m = 0; m < p.cols(); ++m) {
    if (m == i || m == j || m == k) continue;
    if ((p.col(m) - p.col(i) - centre).squaredNorm() < square) return false;
  }
  return true;
}

}  // namespace

StrandSpacing delaunay_spacing(const Eigen::Matrix2Xd& points) {
  const Index n = points.cols();
  Eigen::MatrixXi triangles = Eigen::MatrixXi::Zero(n, n);  // on each edge i < j
  for (Index i = 0; i < n; ++i) {
    for (Index j = i + 1; j < n; ++j) {
      for (Index k = j + 1; k < n; ++k) {
        if (!is_delaunay(points, i, j, k)) continue;
        ++triangles(i, j);
        ++triangles(j, k);
        ++triangles(i, k);
      }
    }
  }
  Eigen::VectorXd nearest(n);
  for (Index i = 0; i < n; ++i) {
    Eigen::VectorXd distances = (points.colwise() - points.col(i)).colwise().norm();
    distances[i] = std::numeric_limits<double>::infinity();
    nearest[i] = distances.minCoeff();
  }
  StrandSpacing spacing;
  for (Index i = 0; i < n; ++i) {
    for (Index j = i + 1; j < n; ++j) {
      if (triangles(i, j) == 0) continue;
      const double reach = first_shell * std::max(nearest[i], nearest[j]);
      if ((points.col(i) - points.col(j)).norm() > reach) continue;
      spacing.mean += (points.col(i) - points.col(j)).norm();
      ++spacing.pairs;
    }
  }
  if (spacing.pairs > 0) spacing.mean /= static_cast<double>(spacing.pairs);
  return spacing;
}

StrandSpacing strand_spacing(const RodState& state, const Points& normals) {
  StrandSpacing total;
  double sum = 0;
  for (Index k = 0; k < normals.cols(); ++k) {
    const Vec3 normal = normals.col(k).normalized();
    const StrandSpacing part = delaunay_spacing(crossings(state, normal));
    sum += part.mean * static_cast<double>(part.pairs);
    total.pairs += part.pairs;
  }
  if (total.pairs > 0) total.mean = sum / static_cast<double>(total.pairs);
  return total;
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
