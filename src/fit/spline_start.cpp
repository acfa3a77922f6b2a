#include "spline_start.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "wirepack/core/rotation.hpp"

#include "interval_ladder.hpp"

namespace wirepack {

Eigen::VectorXd cumulated_chords(const Points& points) {
  Eigen::VectorXd arc = Eigen::VectorXd::Zero(points.cols());
  for (Index i = 1; i < points.cols(); ++i) {
    arc[i] = arc[i - 1] + (points.col(i) - points.col(i - 1)).norm();
  }
  return arc;
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

// Coefficients of the B-spline nearest to values at u; a trace of a ridge keeps those without
// values finite.
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

struct PositionSpline {
  Index intervals = 1;
  Eigen::MatrixXd coefficients;  // rows of x, y, z
};

PositionSpline position_spline(const Points& points, const Eigen::VectorXd& u) {
  PositionSpline best;
  double least = std::numeric_limits<double>::infinity();
  for (const Index intervals : interval_ladder(points.cols() / 3)) {
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

// Nearest places of the points on a polyline, near where they were and on the same turn, as shares
// of its length.
Eigen::VectorXd nearest_parameters(const Points& points, const Eigen::VectorXd& was,
                                   const Points& line) {
  const Eigen::VectorXd arc = cumulated_chords(line);
  const Index m = line.cols(), window = std::max<Index>(3, std::min(m / 20, 8 * m / points.cols()));
  const auto edge = [&](Index j) -> Vec3 { return line.col(j + 1) - line.col(j); };
  Eigen::VectorXd u(was.size());
  for (Index i = 0; i < was.size(); ++i) {
    const auto after = std::upper_bound(arc.data(), arc.data() + m, was[i] * arc[m - 1]);
    const Index guess = std::clamp<Index>(after - arc.data() - 1, 0, m - 2);
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](Index j) {
      const Vec3 e = edge(j), away = points.col(i) - line.col(j);
      const double part = std::clamp(e.dot(away) / e.squaredNorm(), 0.0, 1.0);
      const double distance = (away - part * e).squaredNorm();
      if (distance < least) {
        least = distance;
        u[i] = arc[j] + part * (arc[j + 1] - arc[j]);
      }
      return e.dot(edge(guess)) > 0;  // not yet a quarter of a turn away
    };
    for (Index j = guess; j < std::min(m - 1, guess + window) && look(j); ++j) {
    }
    for (Index j = guess; j >= std::max<Index>(0, guess - window) && look(j); --j) {
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

// Tangent at the middle one of three points of the circle through them: inverted about it, the
// circle is a line.
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

// Shares of the way along ordered points.
Eigen::VectorXd shares_of(const MeasuredPoints& points) {
  const Eigen::VectorXd arc =
      points.arc.size() > 0 ? points.arc : cumulated_chords(points.position);
  return arc / arc[arc.size() - 1];
}

// Arcs of samples on circles: the angle between the chords beside one is that between its tangents.
Eigen::VectorXd arcs_of(const Points& line) {
  const Index n = line.cols();
  Eigen::VectorXd arc = Eigen::VectorXd::Zero(n);
  const auto angle = [&](Index i) {
    const Vec3 a = line.col(i) - line.col(i - 1), b = line.col(i + 1) - line.col(i);
    return std::atan2(a.cross(b).norm(), a.dot(b));
  };
  for (Index i = 1; i < n; ++i) {
    const double before = i > 1 ? angle(i - 1) : 0, after = i + 1 < n ? angle(i) : before;
    const double half = (i > 1 ? before + after : 2 * after) / 4;
    const double chord = (line.col(i) - line.col(i - 1)).norm();
    arc[i] = arc[i - 1] + chord * (half > 1e-6 ? half / std::sin(half) : 1);
  }
  return arc;
}

// Tangents of the circles through samples and their neighbours.
Points tangents_along(const Points& line) {
  const Index last = line.cols() - 1;
  Points tangents(3, last + 1);
  for (Index i = 1; i < last; ++i) {
    tangents.col(i) = tangent_at(line.col(i - 1), line.col(i), line.col(i + 1));
  }
  const auto other_end = [](const Vec3& chord, const Vec3& tangent) -> Vec3 {
    return 2 * chord.dot(tangent) / chord.squaredNorm() * chord - tangent;
  };
  tangents.col(0) = other_end(line.col(1) - line.col(0), tangents.col(1));
  tangents.col(last) = other_end(line.col(last) - line.col(last - 1), tangents.col(last - 1));
  return tangents;
}

// Frames without twist along the samples.
std::vector<Mat3> untwisted_frames(const Points& line) {
  const Points tangents = tangents_along(line);
  Quat frame = frame_with_tangent(tangents.col(0));
  std::vector<Mat3> frames{frame.toRotationMatrix()};
  for (Index i = 1; i < line.cols(); ++i) {
    frame = transport(Vec3(tangents.col(i - 1)), Vec3(tangents.col(i))) * frame;
    frames.push_back(frame.toRotationMatrix());
  }
  return frames;
}

// Bending k1, k2 between the frames: the angle between tangents over the arc.
Eigen::Matrix2Xd bending_between(const std::vector<Mat3>& frames, const Eigen::VectorXd& arcs) {
  const Index n = arcs.size();
  Eigen::Matrix2Xd bending(2, n);
  for (Index i = 0; i < n; ++i) {
    const Index a = std::max<Index>(i - 1, 0), b = std::min(i + 1, n - 1);
    const Vec3 from = frames[static_cast<std::size_t>(a)].col(2);
    const Vec3 to = frames[static_cast<std::size_t>(b)].col(2);
    const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
    const double over_chord = angle > 1e-6 ? angle / (2 * std::sin(angle / 2)) : 1;
    const Vec3 bend = over_chord * (to - from) / (arcs[b] - arcs[a]);
    const Mat3& frame = frames[static_cast<std::size_t>(i)];
    bending.col(i) << -bend.dot(frame.col(1)), bend.dot(frame.col(0));  // t' = k2 d1 - k1 d2
  }
  return bending;
}

}  // namespace

StartLine smoothed_line(const MeasuredPoints& points) {
  const Index last = points.count() - 1;
  StartLine line;
  line.place = shares_of(points);
  for (int round = 0; round < 3; ++round) {
    const PositionSpline spline = position_spline(points.position, line.place);
    line.intervals = spline.intervals;
    line.samples = on_spline(spline, Eigen::VectorXd::LinSpaced(40 * spline.intervals + 1, 0, 1));
    if (points.arc.size() == 0 && round < 2) {
      line.place = nearest_parameters(points.position, line.place, line.samples);
      line.place = (line.place.array() - line.place[0]) / (line.place[last] - line.place[0]);
    }
  }
  return line;
}

StartLine line_through(const MeasuredPoints& points) {
  constexpr Index parts = 8;
  const std::vector<Index> kept = without_repeats(points.position);
  StartLine line{blended_circles(points.position(Eigen::all, kept), parts), shares_of(points),
                 points.count() / 3};
  if (points.arc.size() > 0) return line;
  const Eigen::VectorXd arcs = cumulated_chords(line.samples);
  for (Index i = 0, k = 0; i < points.count(); ++i) {
    if (k + 1 < std::ssize(kept) && kept[static_cast<std::size_t>(k + 1)] <= i) ++k;
    line.place[i] = arcs[k * parts] / arcs[arcs.size() - 1];
  }
  return line;
}

SplineStart::SplineStart(const MeasuredPoints& points, const StartLine& line) {
  const Points& samples = line.samples;
  arcs_ = arcs_of(samples);
  length_ = arcs_[arcs_.size() - 1];
  if (points.arc.size() > 0) {
    feet_ = points.arc;
    arcs_ *= feet_[feet_.size() - 1] / length_;
    length_ = feet_[feet_.size() - 1];
  } else {
    feet_ = length_ * nearest_parameters(points.position, line.place, samples);
  }
  const std::vector<Mat3> frames = untwisted_frames(samples);
  bending_ = bending_between(frames, arcs_);
  const Index n = samples.cols();
  const auto after = std::upper_bound(arcs_.data(), arcs_.data() + n, length_ / 2) - arcs_.data();
  const double part = (length_ / 2 - arcs_[after - 1]) / (arcs_[after] - arcs_[after - 1]);
  const Mat3& before = frames[static_cast<std::size_t>(after - 1)];
  const Mat3& behind = frames[static_cast<std::size_t>(after)];
  middle_.position = on_circle(samples.col(after - 1), before.col(2), samples.col(after), part);
  middle_.directors = Quat(before).slerp(part, Quat(behind)).toRotationMatrix();
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
