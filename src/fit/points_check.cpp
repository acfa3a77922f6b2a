#include "points_check.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "wirepack/core/error.hpp"

#include "index_lists.hpp"

namespace wirepack {

namespace {

std::string name_of(const MeasuredPoints& points, Index i) {
  return points.line.empty() ? fmt::format("point {}", i + 1)
                             : fmt::format("line {}", points.line[static_cast<std::size_t>(i)]);
}

struct Squares {
  double chord = 0, arc = 0;  // sums over all pairs so many points apart
};

Squares squares_of(const MeasuredPoints& points, const std::vector<Index>& order, std::size_t lag) {
  Squares sum;
  for (std::size_t k = 0; k + lag < order.size(); ++k) {
    const Index a = order[k], b = order[k + lag];
    sum.chord += (points.position.col(b) - points.position.col(a)).squaredNorm();
    sum.arc += (points.arc[b] - points.arc[a]) * (points.arc[b] - points.arc[a]);
  }
  const auto pairs = static_cast<double>(order.size() - lag);
  return {sum.chord / pairs, sum.arc / pairs};
}

// A chord is never longer than its arc, and grows no faster. The mean square of chords, of which
// scatter is a part that does not grow, is compared between two distances in the list.
void check_arcs(const MeasuredPoints& points) {
  const std::vector<Index> order = order_by(points.arc);
  for (std::size_t lag = 1; 2 * lag < order.size(); lag *= 2) {
    const Squares near = squares_of(points, order, lag), far = squares_of(points, order, 2 * lag);
    const double few = 2 / std::sqrt(static_cast<double>(order.size() - 2 * lag));
    if (far.chord - near.chord <= (1.2 + few) * (far.arc - near.arc)) continue;
    // the clearest pair is the example
    std::size_t worst = 0;
    double most = -std::numeric_limits<double>::infinity();
    const auto excess = [&](std::size_t k) {
      const Index a = order[k], b = order[k + 2 * lag];
      return (points.position.col(b) - points.position.col(a)).norm() -
             (points.arc[b] - points.arc[a]);
    };
    for (std::size_t k = 0; k + 2 * lag < order.size(); ++k) {
      if (excess(k) <= most) continue;
      most = excess(k);
      worst = k;
    }
    const Index a = order[worst], b = order[worst + 2 * lag];
    throw InvalidInput(fmt::format(
        "the arc lengths are shorter than the way between the points: {} and {} have arc lengths "
        "{:.6g} and {:.6g}, {:.6g} apart, but the chord between them is {:.6g}; is that column an "
        "arc length, in the unit of the points?",
        name_of(points, a), name_of(points, b), points.arc[a], points.arc[b],
        points.arc[b] - points.arc[a], (points.position.col(b) - points.position.col(a)).norm()));
  }
}

}  // namespace

Index fewest_points(ShapeModel model) { return model == ShapeModel::spline ? 8 : 4; }

void check_points(const MeasuredPoints& points, const FitOptions& options) {
  const Index n = points.count(), least = fewest_points(options.model);
  const char* model = options.model == ShapeModel::circle  ? "circle"
                      : options.model == ShapeModel::helix ? "helix"
                                                           : "spline";
  std::set<std::tuple<double, double, double>> distinct;
  for (Index i = 0; i < n; ++i) {
    distinct.insert({points.position(0, i), points.position(1, i), points.position(2, i)});
  }
  const auto different = static_cast<Index>(distinct.size());
  if (different < least) {
    throw InvalidInput(
        fmt::format("{} point{}, {} of them different: a {} with its errors needs at least {}", n,
                    n == 1 ? "" : "s", different, model, least));
  }
  if (points.arc.size() > 0) check_arcs(points);
  if (options.intervals) {
    const Index most = std::min((2 * n - 5) / 2 - 3, most_intervals);
    if (*options.intervals < 1 || *options.intervals > most) {
      throw InvalidInput(std::to_string(*options.intervals) +
                         " intervals of a spline: must be from 1 to " + std::to_string(most) +
                         " for " + std::to_string(n) + " points");
    }
  }
}

}  // namespace wirepack
