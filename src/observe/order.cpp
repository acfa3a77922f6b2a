#include "wirepack/observe/order.hpp"

#include <Eigen/Eigenvalues>
#include <cassert>
#include <cmath>
#include <vector>

namespace wirepack {

AxialOrder axial_order(const Points& axes) {
  AxialOrder result;
  if (axes.cols() == 0) return result;
  const Mat3 mean = axes * axes.transpose() / static_cast<double>(axes.cols());
  const Mat3 q = 1.5 * mean - 0.5 * Mat3::Identity();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(q);
  result.eigenvalues = solver.eigenvalues().reverse();
  result.director = solver.eigenvectors().col(2);
  return result;
}

double alignment(const Points& axes, const Vec3& direction) {
  if (axes.cols() == 0) return 0;
  return 1.5 * (direction.transpose() * axes).squaredNorm() / static_cast<double>(axes.cols()) -
         0.5;
}

Points edge_tangents(const RodState& state) {
  Points tangents(3, state.edge_count());
  for (Index j = 0; j < state.edge_count(); ++j) {
    tangents.col(j) = (state.nodes.col(next_node(state, j)) - state.nodes.col(j)).normalized();
  }
  return tangents;
}

Points coil_axes(const RodState& state) {
  assert(!state.ends.closed);
  const Points tangents = edge_tangents(state);
  const Index edges = state.edge_count();
  // Sums from the first node on: r x dr, and the nodes themselves.
  Points swept = Points::Zero(3, edges + 1), passed = Points::Zero(3, edges + 2);
  for (Index i = 0; i <= edges; ++i) {
    const Vec3 r = state.nodes.col(i);
    passed.col(i + 1) = passed.col(i) + r;
    if (i < edges) swept.col(i + 1) = swept.col(i) + r.cross(Vec3(state.nodes.col(i + 1)));
  }
  const auto angle_at = [&](Index node) {  // between the edges that meet there
    const Vec3 a = tangents.col(node - 1), b = tangents.col(node);
    return std::atan2(a.cross(b).norm(), a.dot(b));
  };
  std::vector<Vec3> axes;
  Index last = 0;  // the turn that starts with edge `first` ends with this edge
  double turned = 0;
  for (Index first = 0; first < edges; ++first) {
    while (turned < 2 * pi * (1 - 1e-9) && last + 1 < edges) turned += angle_at(++last);
    if (turned < 2 * pi * (1 - 1e-9)) break;
    const Vec3 mean =
        (passed.col(last + 1) - passed.col(first)) / static_cast<double>(last - first + 1);
    const Vec3 travelled = state.nodes.col(last) - state.nodes.col(first);
    const Vec3 area = swept.col(last) - swept.col(first) - mean.cross(travelled);
    if (area.norm() > 0) axes.push_back(area.normalized());
    if (first + 1 < edges) turned -= angle_at(first + 1);
  }
  Points result(3, static_cast<Index>(axes.size()));
  for (std::size_t k = 0; k < axes.size(); ++k) result.col(static_cast<Index>(k)) = axes[k];
  return result;
}

}  // namespace wirepack
