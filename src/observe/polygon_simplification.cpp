#include "polygon_simplification.hpp"

#include <algorithm>
#include <vector>

#include "wirepack/core/random.hpp"

namespace wirepack {

namespace {

using Box = Eigen::AlignedBox3d;

double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

// Touching counts.
bool meets_triangle(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  if (volume(a, b, c, p) * volume(a, b, c, q) > 0) return false;
  const double u = volume(p, q, a, b), v = volume(p, q, b, c), w = volume(p, q, c, a);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

/// One round around the polygon. Edges are known by their first corner; boxes around those of
/// successive corners tell at once which are far from a triangle.
class Round {
 public:
  explicit Round(const Points& corners)
      : corners_(corners), next_(static_cast<std::size_t>(corners.cols())), left_(corners.cols()) {
    for (Index i = 0; i < corners.cols(); ++i) {
      if (i % block == 0) boxes_.emplace_back();
      next_[static_cast<std::size_t>(i)] = (i + 1) % corners.cols();
      boxes_.back().extend(corners.col(i)).extend(corners.col((i + 1) % corners.cols()));
    }
  }

  Points cut_corners() {
    // the corner that the last step reaches again is the first one, which stays
    Index before = 0, corner = next(before);
    while (corner != 0 && left_ > 3) {
      const Index after = next(corner);
      if (is_free(before, corner, after)) {
        cut(before, corner, after);
      } else {
        before = corner;
      }
      corner = after;
    }
    return remaining();
  }

 private:
  static constexpr Index block = 32;
  static constexpr Index gone = -1;

  Index next(Index i) const { return next_[static_cast<std::size_t>(i)]; }

  void cut(Index before, Index corner, Index after) {
    next_[static_cast<std::size_t>(before)] = after;
    next_[static_cast<std::size_t>(corner)] = gone;
    boxes_[static_cast<std::size_t>(before / block)].extend(corners_.col(after));
    --left_;
  }

  bool is_free(Index before, Index corner, Index after) const {
    const Vec3 a = corners_.col(before), b = corners_.col(corner), c = corners_.col(after);
    Box box(a);
    box.extend(b).extend(c);
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
      if (!boxes_[k].intersects(box)) continue;
      const Index first = static_cast<Index>(k) * block;
      for (Index i = first; i < std::min(first + block, corners_.cols()); ++i) {
        // its own edges, and those that share a corner with it
        if (next(i) == gone || i == before || i == corner || i == after || next(i) == before) {
          continue;
        }
        const Vec3 p = corners_.col(i), q = corners_.col(next(i));
        if (meets_triangle(p, q, a, b, c)) return false;
      }
    }
    return true;
  }

  Points remaining() const {
    Points result(3, left_);
    Index corner = 0;
    for (Index k = 0; k < left_; ++k, corner = next(corner)) result.col(k) = corners_.col(corner);
    return result;
  }

  const Points& corners_;
  std::vector<Index> next_;
  std::vector<Box> boxes_;
  Index left_;
};

}  // namespace

Points simplified_polygon(const Points& polygon) {
  // flat and collinear corners are made general by far less than any gap
  Random random(1);
  Points corners = polygon;
  const double shift = 1e-9 * (polygon.rowwise().maxCoeff() - polygon.rowwise().minCoeff()).norm();
  for (double& x : corners.reshaped()) x += shift * random.symmetric();
  while (true) {
    Points fewer = Round(corners).cut_corners();
    if (fewer.cols() == corners.cols()) return fewer;
    // the first corner stays in its round, so another one is first in the next
    const Index n = fewer.cols();
    corners.resize(3, n);
    corners << fewer.rightCols(n - 1), fewer.leftCols(1);
  }
}

}  // namespace wirepack
