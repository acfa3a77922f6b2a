#include "far_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "extent.hpp"
#include "index_lists.hpp"

namespace wirepack {

namespace {

constexpr double alone = 6;  // distances of the rest from their neighbours

// Distance of each point from its nearest neighbour. Points are sorted by the coordinate that
// extends most, so that few others need a look.
Eigen::VectorXd neighbour_distances(const Points& points) {
  Index axis = 0;
  box_of(points).maxCoeff(&axis);
  const std::vector<Index> sorted = order_by(points.row(axis));
  Eigen::VectorXd nearest =
      Eigen::VectorXd::Constant(points.cols(), std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const Index i = sorted[k];
    double& least = nearest[i];
    const auto look = [&](Index j) {
      if (std::abs(points(axis, j) - points(axis, i)) >= least) return false;
      const double distance = (points.col(j) - points.col(i)).norm();
      if (distance > 0) least = std::min(least, distance);  // the same point twice is no neighbour
      return true;
    };
    for (std::size_t other = k + 1; other < sorted.size() && look(sorted[other]); ++other) {
    }
    for (std::size_t other = k; other-- > 0 && look(sorted[other]);) {
    }
  }
  return nearest;
}

}  // namespace

std::vector<Index> far_points(const Points& points) {
  const Index n = points.cols(), most = std::max<Index>(1, n / 20);
  const Eigen::VectorXd nearest = neighbour_distances(points);
  const std::vector<Index> order = order_by(-nearest);
  for (Index count = std::min(most, n - 1); count > 0; --count) {
    const auto at = [&](Index k) { return nearest[order[static_cast<std::size_t>(k)]]; };
    if (!(at(count - 1) > alone * at(count))) continue;
    std::vector<Index> far(order.begin(), order.begin() + count);
    std::sort(far.begin(), far.end());
    return far;
  }
  return {};
}

}  // namespace wirepack
