#include "far_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace wirepack {

namespace {

constexpr double alone = 6;  // distances of the rest from their neighbours

// Distance of each point from its nearest neighbour. Points are sorted by the coordinate that
// extends most, so that few others need a look.
std::vector<double> neighbour_distances(const Points& points) {
  Index axis = 0;
  (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff(&axis);
  std::vector<Index> sorted(static_cast<std::size_t>(points.cols()));
  std::iota(sorted.begin(), sorted.end(), Index{0});
  std::sort(sorted.begin(), sorted.end(),
            [&](Index a, Index b) { return points(axis, a) < points(axis, b); });
  std::vector<double> nearest(sorted.size(), std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const Index i = sorted[k];
    double& least = nearest[static_cast<std::size_t>(i)];
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
  const std::vector<double> nearest = neighbour_distances(points);
  std::vector<Index> order(nearest.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return nearest[static_cast<std::size_t>(a)] > nearest[static_cast<std::size_t>(b)];
  });
  for (Index count = std::min(most, n - 1); count > 0; --count) {
    const auto at = [&](Index k) {
      return nearest[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])];
    };
    if (!(at(count - 1) > alone * at(count))) continue;
    std::vector<Index> far(order.begin(), order.begin() + count);
    std::sort(far.begin(), far.end());
    return far;
  }
  return {};
}

}  // namespace wirepack
