#include "point_order.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace wirepack {

namespace {

// Means of groups of points: each point belongs to the first kept one within the radius, or is kept.
Points group_means(const Points& points, double radius) {
  std::vector<Vec3> kept, sum;
  std::vector<double> count;
  for (Index i = 0; i < points.cols(); ++i) {
    const Vec3 p = points.col(i);
    std::size_t g = 0;
    while (g < kept.size() && (kept[g] - p).squaredNorm() > radius * radius) ++g;
    if (g == kept.size()) {
      kept.push_back(p);
      sum.emplace_back(Vec3::Zero());
      count.push_back(0);
    }
    sum[g] += p;
    count[g] += 1;
  }
  Points means(3, static_cast<Index>(kept.size()));
  for (std::size_t g = 0; g < kept.size(); ++g) {
    means.col(static_cast<Index>(g)) = sum[g] / count[g];
  }
  return means;
}

// Grows at both of its ends, always by the point that is nearest to either.
std::vector<Index> nearest_chain(const Points& points) {
  std::vector<Index> left(static_cast<std::size_t>(points.cols() - 1));
  std::iota(left.begin(), left.end(), Index{1});
  std::array<std::vector<Index>, 2> sides{{{0}, {}}};
  struct Next {
    double distance;
    std::size_t place;  // in `left`
  };
  const auto nearest_to = [&](Index end) {
    Next next{std::numeric_limits<double>::infinity(), 0};
    for (std::size_t k = 0; k < left.size(); ++k) {
      const double distance = (points.col(left[k]) - points.col(end)).squaredNorm();
      if (distance < next.distance) next = {distance, k};
    }
    return next;
  };
  while (!left.empty()) {
    const Next first = nearest_to(sides[0].back());
    const Next second = nearest_to(sides[1].empty() ? 0 : sides[1].back());
    const std::size_t side = first.distance <= second.distance ? 0 : 1;
    Index& taken = left[(side == 0 ? first : second).place];
    sides[side].push_back(taken);
    taken = left.back();
    left.pop_back();
  }
  std::vector<Index> chain(sides[1].rbegin(), sides[1].rend());
  chain.insert(chain.end(), sides[0].begin(), sides[0].end());
  return chain;
}

// The chain goes on as a wire does: no gap far above the usual step, hardly a sharp turn.
bool is_a_wire(const Points& points, const std::vector<Index>& chain) {
  std::vector<double> steps;
  Index sharp = 0;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Vec3 e = points.col(chain[i]) - points.col(chain[i - 1]);
    steps.push_back(e.norm());
    if (i < 2) continue;
    const Vec3 before = points.col(chain[i - 1]) - points.col(chain[i - 2]);
    if (e.dot(before) < 0.3 * e.norm() * before.norm()) ++sharp;
  }
  const double longest = *std::max_element(steps.begin(), steps.end());
  std::nth_element(steps.begin(), steps.begin() + std::ssize(steps) / 2, steps.end());
  return longest < 8 * steps[steps.size() / 2] && 20 * sharp < std::ssize(chain);
}

double median_neighbour_distance(const Points& points) {
  const Index stride = std::max<Index>(1, points.cols() / 200);
  std::vector<double> nearest;
  for (Index i = 0; i < points.cols(); i += stride) {
    double least = std::numeric_limits<double>::infinity();
    for (Index j = 0; j < points.cols(); ++j) {
      if (j != i) least = std::min(least, (points.col(j) - points.col(i)).squaredNorm());
    }
    nearest.push_back(std::sqrt(least));
  }
  std::nth_element(nearest.begin(), nearest.begin() + std::ssize(nearest) / 2, nearest.end());
  return nearest[nearest.size() / 2];
}

// Arc of a point's place on the polyline through the means, in edges.
double place_on(const Points& line, const Vec3& point) {
  double best = std::numeric_limits<double>::infinity(), place = 0;
  for (Index i = 0; i + 1 < line.cols(); ++i) {
    const Vec3 a = line.col(i), e = line.col(i + 1) - a;
    // the end edges go on, for the points beyond the means at the ends
    const double low = i == 0 ? -1 : 0, high = i + 2 == line.cols() ? 2 : 1;
    const double u = std::clamp(e.dot(point - a) / e.squaredNorm(), low, high);
    const double distance = (a + u * e - point).squaredNorm();
    if (distance < best) {
      best = distance;
      place = static_cast<double>(i) + u;
    }
  }
  return place;
}

}  // namespace

std::vector<Index> order_along_wire(const Points& points) {
  const double spacing = median_neighbour_distance(points);
  const double extent = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
  double radius = std::max(0.5 * spacing, 1e-3 * extent);
  for (; radius < extent / 4; radius *= 1.5) {
    const Points means = group_means(points, radius);
    if (means.cols() < 4) break;
    const std::vector<Index> chain = nearest_chain(means);
    if (!is_a_wire(means, chain)) continue;
    Points line(3, means.cols());
    for (Index i = 0; i < line.cols(); ++i)
      line.col(i) = means.col(chain[static_cast<std::size_t>(i)]);
    std::vector<double> place;
    for (Index i = 0; i < points.cols(); ++i) place.push_back(place_on(line, points.col(i)));
    std::vector<Index> order(place.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
      return place[static_cast<std::size_t>(a)] < place[static_cast<std::size_t>(b)];
    });
    return order;
  }
  return {};
}

}  // namespace wirepack
