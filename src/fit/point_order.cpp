#include "point_order.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <limits>

#include "block_means.hpp"
#include "extent.hpp"
#include "index_lists.hpp"

namespace wirepack {

namespace {

// Means of groups of points: each point belongs to the first kept one within the radius, or is
// kept.
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
  std::vector<Index> left = consecutive(1, points.cols() - 1);
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

constexpr double long_step = 8;     // of a gap, in median steps
constexpr double sharp_turn = 0.3;  // cosine

// How a chain goes on: lengths of its steps, the turns between them, and where it jumps.
struct Course {
  Eigen::VectorXd step;
  Eigen::VectorXd cosine;  // of the turn behind each step but the last
  double median = 0;

  Index sharp() const { return (cosine.array() < sharp_turn).count(); }
  bool jumps(Index i) const { return step[i] > long_step * median; }
  bool jumps() const { return step.size() > 0 && step.maxCoeff() > long_step * median; }
  bool hardly_turns() const { return 20 * sharp() <= step.size() + 10; }
  // A gap that the wire crosses straight on is one where points are missing.
  bool jumps_sharply() const {
    for (Index i = 0; i < step.size(); ++i) {
      if (!jumps(i)) continue;
      if (i > 0 && cosine[i - 1] < sharp_turn) return true;
      if (i < cosine.size() && cosine[i] < sharp_turn) return true;
    }
    return false;
  }
};

double median_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Course course_of(const Points& chain) {
  // a point twice is no turn
  std::vector<Vec3> steps;
  for (Index i = 1; i < chain.cols(); ++i) {
    const Vec3 step = chain.col(i) - chain.col(i - 1);
    if (step.squaredNorm() > 0) steps.push_back(step);
  }
  const auto count = static_cast<Index>(steps.size());
  Course course{Eigen::VectorXd(count), Eigen::VectorXd(std::max<Index>(count - 1, 0))};
  for (Index i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    course.step[i] = steps[k].norm();
    if (i > 0) {
      course.cosine[i - 1] = steps[k].dot(steps[k - 1]) / (course.step[i] * course.step[i - 1]);
    }
  }
  course.median = median_of({course.step.begin(), course.step.end()});
  return course;
}

// The chain goes on as a wire does: no gap far above the usual step, hardly a sharp turn.
bool is_a_wire(const Points& chain) {
  const Course course = course_of(chain);
  return !course.jumps() && course.hardly_turns();
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
  return median_of(std::move(nearest));
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

// A part of the list without a jump, or that part backwards.
struct Piece {
  Index first, last;
};

std::vector<Piece> pieces_of(const Points& points) {
  const Course course = course_of(points);
  std::vector<Piece> pieces{{0, 0}};
  for (Index i = 1; i < points.cols(); ++i) {
    const double step = (points.col(i) - points.col(i - 1)).norm();
    if (step > long_step * course.median) pieces.push_back({i, i});
    pieces.back().last = i;
  }
  return pieces;
}

// Pieces put together at the nearest of their ends, a chain that grows at both of its own.
std::vector<Index> joined(const Points& points, std::vector<Piece> left) {
  std::deque<Piece> chain{left.front()};
  left.erase(left.begin());
  struct Join {
    double gap = std::numeric_limits<double>::infinity();
    std::size_t piece = 0;
    bool at_end = true, backwards = false;
  };
  while (!left.empty()) {
    Join best;
    for (std::size_t k = 0; k < left.size(); ++k) {
      for (const bool at_end : {true, false}) {
        const Index end = at_end ? chain.back().last : chain.front().first;
        for (const bool backwards : {false, true}) {
          const Index other = at_end != backwards ? left[k].first : left[k].last;
          const double gap = (points.col(end) - points.col(other)).norm();
          if (gap < best.gap) best = {gap, k, at_end, backwards};
        }
      }
    }
    Piece piece = left[best.piece];
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best.piece));
    if (best.backwards) std::swap(piece.first, piece.last);
    if (best.at_end) {
      chain.push_back(piece);
    } else {
      chain.push_front(piece);
    }
  }
  std::vector<Index> order;
  for (const Piece& piece : chain) {
    const Index sense = piece.last >= piece.first ? 1 : -1;
    for (Index i = piece.first; i != piece.last + sense; i += sense) order.push_back(i);
  }
  return order;
}

}  // namespace

std::vector<Index> order_of_list(const Points& points) {
  const std::vector<Index> list = consecutive(0, points.cols());
  const Course course = course_of(points);
  if (course.jumps()) {
    // parts that are joined without a jump, and without a turn that the list does not have
    const std::vector<Piece> pieces = pieces_of(points);
    if (20 * std::ssize(pieces) <= points.cols()) {
      std::vector<Index> order = joined(points, pieces);
      const Course of_joined = course_of(points(Eigen::all, order));
      const bool smooth = of_joined.hardly_turns() && of_joined.sharp() <= course.sharp();
      if (!of_joined.jumps() && smooth) return order;
    }
  }
  MeasuredPoints all;
  all.position = points;
  constexpr Index fewest = 8;
  for (Index count = points.cols(); count >= fewest || count == points.cols(); count /= 2) {
    const Course of_means = course_of(block_means(all, count).points.position);
    if (of_means.hardly_turns() && !of_means.jumps_sharply()) return list;
  }
  return {};
}

std::vector<Index> spikes_of_list(const Points& points) {
  std::vector<Index> spikes, rest;
  for (const Piece& piece : pieces_of(points)) {
    if (piece.first == piece.last) {
      spikes.push_back(piece.first);
    } else {
      for (Index i = piece.first; i <= piece.last; ++i) rest.push_back(i);
    }
  }
  const Index most = std::max<Index>(1, points.cols() / 20);
  if (std::ssize(spikes) > most || rest.size() < 4) return {};
  const std::vector<Index> order = order_of_list(points(Eigen::all, rest));
  return std::is_sorted(order.begin(), order.end()) && !order.empty() ? spikes
                                                                      : std::vector<Index>{};
}

std::vector<Index> order_along_wire(const Points& points) {
  const double spacing = median_neighbour_distance(points);
  const double extent = extent_of(points);
  double radius = std::max(0.5 * spacing, 1e-3 * extent);
  for (; radius < extent / 4; radius *= 1.5) {
    const Points means = group_means(points, radius);
    if (means.cols() < 4) break;
    const Points line = means(Eigen::all, nearest_chain(means));
    if (!is_a_wire(line)) continue;
    Eigen::VectorXd place(points.cols());
    for (Index i = 0; i < points.cols(); ++i) place[i] = place_on(line, points.col(i));
    return order_by(place);
  }
  return {};
}

}  // namespace wirepack
