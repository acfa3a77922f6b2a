#include "spline_start.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "block_means.hpp"

namespace wirepack {

double schwarz_criterion(double sum_of_squares, Index residuals, Index unknowns) {
  const auto n = static_cast<double>(residuals);
  return n * std::log(sum_of_squares / n + 1e-22) + static_cast<double>(unknowns) * std::log(n);
}

std::vector<Index> interval_ladder(Index most) {
  std::vector<Index> ladder{1};
  for (Index power = 2; power <= most; power *= 2) {
    ladder.push_back(power);
    if (power * 3 / 2 <= most) ladder.push_back(power * 3 / 2);
  }
  return ladder;
}

namespace {

// Values of a B-spline at u in [0, 1], from coefficients in rows.
Eigen::MatrixXd spline_values(const Eigen::MatrixXd& coefficients, const Eigen::VectorXd& u) {
  const DarbouxBasis basis{coefficients.rows() - 3, false, 0, 1};
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(u.size(), coefficients.cols());
  for (Index i = 0; i < u.size(); ++i) {
    for (const auto& w : basis.weights(u[i])) {
      if (w.component == 0) values.row(i) += w.value * coefficients.row(w.unknown);
    }
  }
  return values;
}

// Coefficients of the B-spline nearest to values at u; a trace of a ridge keeps those without values
// finite.
Eigen::MatrixXd spline_through(const Eigen::MatrixXd& values, const Eigen::VectorXd& u,
                               Index intervals) {
  const DarbouxBasis basis{intervals, false, 0, 1};
  const Index size = intervals + 3;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(size, values.cols());
  for (Index i = 0; i < u.size(); ++i) {
    const std::vector<DarbouxBasis::Weight> weights = basis.weights(u[i]);
    for (int a = 0; a < 4; ++a) {  // those of the first component come first
      const auto& wa = weights[static_cast<std::size_t>(a)];
      right.row(wa.unknown) += wa.value * values.row(i);
      for (int b = 0; b < 4; ++b) {
        const auto& wb = weights[static_cast<std::size_t>(b)];
        normal(wa.unknown, wb.unknown) += wa.value * wb.value;
      }
    }
  }
  normal.diagonal().array() += 1e-10 * normal.trace() / static_cast<double>(size);
  return normal.llt().solve(right);
}

Eigen::VectorXd cumulated_chords(const Points& points) {
  Eigen::VectorXd arc = Eigen::VectorXd::Zero(points.cols());
  for (Index i = 1; i < points.cols(); ++i) {
    arc[i] = arc[i - 1] + (points.col(i) - points.col(i - 1)).norm();
  }
  return arc;
}

struct PositionSpline {
  Index intervals = 1;
  Eigen::MatrixXd coefficients;  // rows of x, y, z
};

PositionSpline position_spline(const Points& points, const Eigen::VectorXd& u) {
  PositionSpline best;
  double least = std::numeric_limits<double>::infinity();
  for (const Index intervals : interval_ladder(std::min<Index>(points.cols() / 3, 96))) {
    const Eigen::MatrixXd coefficients = spline_through(points.transpose(), u, intervals);
    const double sum = (spline_values(coefficients, u) - points.transpose()).squaredNorm();
    const double criterion = schwarz_criterion(sum, 3 * points.cols(), 3 * (intervals + 3));
    if (criterion < least) {
      least = criterion;
      best = {intervals, coefficients};
    }
  }
  return best;
}

Points on_spline(const PositionSpline& spline, const Eigen::VectorXd& u) {
  return spline_values(spline.coefficients, u).transpose();
}

// Nearest places of the points on a polyline, near where they were, as shares of its length.
Eigen::VectorXd nearest_parameters(const Points& points, const Eigen::VectorXd& was,
                                   const Points& line) {
  const Eigen::VectorXd arc = cumulated_chords(line);
  const Index m = line.cols(), window = std::max<Index>(3, std::min(m / 20, 8 * m / points.cols()));
  Eigen::VectorXd u(was.size());
  for (Index i = 0; i < was.size(); ++i) {
    const auto guess = static_cast<Index>(was[i] * static_cast<double>(m - 1));
    double least = std::numeric_limits<double>::infinity();
    for (Index j = std::max<Index>(0, guess - window); j < std::min(m - 1, guess + window); ++j) {
      const Vec3 e = line.col(j + 1) - line.col(j);
      const Vec3 away = points.col(i) - line.col(j);
      const double part = std::clamp(e.dot(away) / e.squaredNorm(), 0.0, 1.0);
      const double distance = (away - part * e).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      u[i] = arc[j] + part * (arc[j + 1] - arc[j]);
    }
  }
  return u / arc[m - 1];
}

// Place at a share of the way from a to b on a circle that leaves a along a tangent.
Vec3 on_circle(const Vec3& a, const Vec3& tangent, const Vec3& b, double share) {
  const Vec3 chord = b - a;
  const double angle = std::atan2(tangent.cross(chord).norm(), tangent.dot(chord));
  const Vec3 across = chord - chord.dot(tangent) * tangent;
  if (angle < 1e-6 || !(across.norm() > 0)) return a + share * chord;
  const double part = share * angle;
  return a + chord.norm() * std::sin(part) / std::sin(angle) *
                 (std::cos(part) * tangent + std::sin(part) * across.normalized());
}

// Tangent at the middle one of three points of the circle through them: inverted about it, the circle
// is a line.
Vec3 tangent_at(const Vec3& before, const Vec3& here, const Vec3& after) {
  const Vec3 a = here - before, b = after - here;
  return (a / a.squaredNorm() + b / b.squaredNorm()).normalized();
}

// Through all points, `parts` to a step: between two of them, a blend of the circles through either
// and its neighbours, on which points of a coil may be a sixth of a turn apart.
Points blended_circles(const Points& points, Index parts) {
  const Index n = points.cols();
  Points line(3, (n - 1) * parts + 1);
  for (Index i = 0; i + 1 < n; ++i) {
    const Vec3 a = points.col(i), b = points.col(i + 1);
    const bool first = i == 0, last = i + 2 == n;
    const Vec3 from = first ? a : tangent_at(points.col(i - 1), a, b);
    const Vec3 to = last ? b : tangent_at(a, b, points.col(i + 2));
    for (Index k = 0; k < parts; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(parts);
      const Vec3 one = first ? on_circle(b, -to, a, 1 - share) : on_circle(a, from, b, share);
      const Vec3 other = last ? one : on_circle(b, -to, a, 1 - share);
      line.col(i * parts + k) = (1 - share) * one + share * other;
    }
  }
  line.col(line.cols() - 1) = points.col(n - 1);
  return line;
}

// Without those that are where the one before is.
std::vector<Index> without_repeats(const Points& points) {
  std::vector<Index> kept{0};
  for (Index i = 1; i < points.cols(); ++i) {
    if ((points.col(i) - points.col(kept.back())).norm() > 1e-9) kept.push_back(i);
  }
  return kept;
}

}  // namespace

SplineStart::SplineStart(const MeasuredPoints& points, SplineLine how) {
  const bool known_arcs = points.arc.size() > 0;
  const BlockMeans blocks = block_means(points);
  const Points& means = blocks.points.position;
  const Index last = means.cols() - 1;
  Eigen::VectorXd u = known_arcs ? blocks.points.arc : cumulated_chords(means);
  u /= known_arcs ? points.arc[points.count() - 1] : u[last];
  Points line;
  if (how == SplineLine::through_points) {
    constexpr Index parts = 8;
    const std::vector<Index> kept = without_repeats(means);
    line = blended_circles(means(Eigen::all, kept), parts);
    intervals_ = means.cols() / 3;
    const Eigen::VectorXd arcs = cumulated_chords(line);
    for (Index i = 0, k = 0; i <= last && !known_arcs; ++i) {
      if (k + 1 < std::ssize(kept) && kept[static_cast<std::size_t>(k + 1)] <= i) ++k;
      u[i] = arcs[k * parts] / arcs[arcs.size() - 1];
    }
  } else {
    PositionSpline spline;
    Eigen::VectorXd fine;
    for (int round = 0; round < 3; ++round) {
      spline = position_spline(means, u);
      fine = Eigen::VectorXd::LinSpaced(40 * spline.intervals + 1, 0, 1);
      if (!known_arcs && round < 2) {
        u = nearest_parameters(means, u, on_spline(spline, fine));
        u = (u.array() - u[0]) / (u[last] - u[0]);
      }
    }
    intervals_ = spline.intervals;
    line = on_spline(spline, fine);
  }
  arcs_ = cumulated_chords(line);
  length_ = arcs_[arcs_.size() - 1];
  if (known_arcs) {
    feet_ = points.arc;
    arcs_ *= feet_[feet_.size() - 1] / length_;
    length_ = feet_[feet_.size() - 1];
  } else {
    Eigen::VectorXd of_points(points.count());
    for (Index i = 0; i < points.count(); ++i) {
      of_points[i] = u[blocks.of_point[static_cast<std::size_t>(i)]];
    }
    feet_ = length_ * nearest_parameters(points.position, of_points, line);
  }
  // Frames without twist along the samples, and the bending between them.
  const Index n = line.cols();
  bending_.resize(2, n);
  std::vector<Mat3> frames;
  for (Index i = 0; i < n; ++i) {
    const Index a = std::max<Index>(i - 1, 0), b = std::min(i + 1, n - 1);
    const Vec3 tangent = (line.col(b) - line.col(a)).normalized();
    Vec3 first = frames.empty() ? tangent.unitOrthogonal() : Vec3(frames.back().col(0));
    first = (first - first.dot(tangent) * tangent).normalized();
    Mat3 frame;
    frame << first, tangent.cross(first), tangent;
    frames.push_back(frame);
  }
  for (Index i = 0; i < n; ++i) {
    const Index a = std::max<Index>(i - 1, 0), b = std::min(i + 1, n - 1);
    const Vec3 bend =
        (frames[static_cast<std::size_t>(b)].col(2) - frames[static_cast<std::size_t>(a)].col(2)) /
        (arcs_[b] - arcs_[a]);
    const Mat3& frame = frames[static_cast<std::size_t>(i)];
    bending_.col(i) << -bend.dot(frame.col(1)), bend.dot(frame.col(0));  // t' = k2 d1 - k1 d2
  }
  const auto after = std::upper_bound(arcs_.data(), arcs_.data() + n, length_ / 2) - arcs_.data();
  const double part = (length_ / 2 - arcs_[after - 1]) / (arcs_[after] - arcs_[after - 1]);
  middle_.position = (1 - part) * line.col(after - 1) + part * line.col(after);
  middle_.directors = frames[static_cast<std::size_t>(part < 0.5 ? after - 1 : after)];
}

FitStart SplineStart::with_intervals(Index intervals) const {
  FitStart start;
  start.basis = {intervals, false, 0, length_};
  start.pose = middle_;
  start.feet = feet_;
  const Eigen::MatrixXd coefficients =
      spline_through(bending_.transpose(), arcs_ / length_, intervals);
  start.shape_unknowns.resize(start.basis.size());
  start.shape_unknowns << coefficients.col(0), coefficients.col(1);
  return start;
}

}  // namespace wirepack
