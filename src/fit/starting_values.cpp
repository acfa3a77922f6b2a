#include "starting_values.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace wirepack {

namespace {

// Principal axes of the points as columns, the longest first; right-handed.
Mat3 principal_axes(const Points& points) {
  const Points centred = points.colwise() - points.rowwise().mean();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(centred * centred.transpose());
  Mat3 axes;
  axes.col(0) = solver.eigenvectors().col(2);
  axes.col(1) = solver.eigenvectors().col(1);
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

struct PlaneCircle {
  double x, y, radius;
};

// G. Taubin 1991, by singular values (N. Chernov 2010); nothing when the points are on a line.
std::optional<PlaneCircle> taubin_circle(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  const double mean_x = x.mean(), mean_y = y.mean();
  const Eigen::ArrayXd u = x.array() - mean_x, v = y.array() - mean_y;
  const Eigen::ArrayXd z = u.square() + v.square();
  const double mean_z = z.mean();
  if (!(mean_z > 0)) return std::nullopt;
  Eigen::MatrixX3d rows(x.size(), 3);
  rows.col(0) = (z - mean_z) / (2 * std::sqrt(mean_z));
  rows.col(1) = u;
  rows.col(2) = v;
  // the eigenvector of 3 x 3 loses half the digits, which a start can spare
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(rows.transpose() * rows);
  const Vec3 a = solver.eigenvectors().col(0);
  const double a0 = a[0] / (2 * std::sqrt(mean_z));
  const double radius =
      std::sqrt(a[1] * a[1] + a[2] * a[2] + 4 * a0 * a0 * mean_z) / (2 * std::abs(a0));
  if (!(radius < 1e4 * std::sqrt(mean_z))) return std::nullopt;
  return PlaneCircle{mean_x - a[1] / (2 * a0), mean_y - a[2] / (2 * a0), radius};
}

double wrapped(double angle) { return std::remainder(angle, 2 * pi); }

// Angles as they grow along ordered points; through the blocks, so that scatter does not add turns.
Eigen::VectorXd unwrapped(const Eigen::VectorXd& angles, const Eigen::VectorXd& of_blocks,
                          const std::vector<Index>& block) {
  Eigen::VectorXd smooth = of_blocks;
  for (Index b = 1; b < smooth.size(); ++b) {
    smooth[b] = smooth[b - 1] + wrapped(smooth[b] - smooth[b - 1]);
  }
  Eigen::VectorXd result(angles.size());
  for (Index i = 0; i < angles.size(); ++i) {
    const double guide = smooth[block[static_cast<std::size_t>(i)]];
    result[i] = guide + wrapped(angles[i] - guide);
  }
  return result;
}

// Angles in one turn that begins behind the largest gap.
Eigen::VectorXd behind_largest_gap(const Eigen::VectorXd& angles) {
  std::vector<double> sorted(angles.data(), angles.data() + angles.size());
  std::sort(sorted.begin(), sorted.end());
  double start = sorted.front(), largest = sorted.front() + 2 * pi - sorted.back();
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i] - sorted[i - 1] <= largest) continue;
    largest = sorted[i] - sorted[i - 1];
    start = sorted[i];
  }
  Eigen::VectorXd result = angles;
  for (double& a : result) {
    if (a < start) a += 2 * pi;
  }
  return result;
}

// A helix about an axis: `axes` are u, v, a (right-handed), and its points
// centre + radius (cos(phi) u + sin(phi) v) + rise phi a, at arc phi / rate.
struct AxisHelix {
  Mat3 axes;
  Vec3 centre;
  double radius, rise;
  Eigen::VectorXd phi;  // of each point
};

FitStart start_of(const AxisHelix& helix, bool planar) {
  const double rate = 1 / std::hypot(helix.radius, helix.rise);
  FitStart start;
  start.basis = {0, planar, helix.phi.minCoeff() / rate, helix.phi.maxCoeff() / rate};
  start.feet = helix.phi / rate;
  const double phi = start.basis.middle() * rate;
  const Vec3 outward = helix.axes * Vec3(std::cos(phi), std::sin(phi), 0);
  const Vec3 around = helix.axes * Vec3(-std::sin(phi), std::cos(phi), 0);
  start.pose.position =
      helix.centre + helix.radius * outward + helix.rise * phi * helix.axes.col(2);
  const Vec3 tangent = rate * (helix.radius * around + helix.rise * helix.axes.col(2));
  start.pose.directors << -outward, tangent.cross(-outward), tangent;
  start.shape_unknowns = Eigen::VectorXd::Zero(start.basis.size());
  start.shape_unknowns[1] = helix.radius * rate * rate;  // d1 is the normal: k0 = (0, kappa, tau)
  if (!planar) start.shape_unknowns[2] = helix.rise * rate * rate;
  return start;
}

FitStart straight_start(const MeasuredPoints& points, const Mat3& axes, bool planar) {
  const Vec3 centre = points.position.rowwise().mean();
  Vec3 along = axes.col(0);
  const Index n = points.count();
  if (points.ordered && along.dot(points.position.col(n - 1) - points.position.col(0)) < 0) {
    along = -along;
  }
  FitStart start;
  start.feet = (points.position.colwise() - centre).transpose() * along;
  start.basis = {0, planar, start.feet.minCoeff(), start.feet.maxCoeff()};
  start.pose.position = centre + start.basis.middle() * along;
  start.pose.directors << axes.col(1), along.cross(axes.col(1)), along;
  start.shape_unknowns = Eigen::VectorXd::Zero(start.basis.size());
  return start;
}

struct Cylinder {
  Mat3 axes;
  PlaneCircle circle;
  Eigen::VectorXd angle, height;  // of each point
};

std::optional<Cylinder> cylinder_about(const Points& points, const Vec3& axis) {
  Mat3 axes;
  axes.col(0) = axis.unitOrthogonal();
  axes.col(1) = axis.cross(axes.col(0));
  axes.col(2) = axis;
  const Points local = axes.transpose() * points;
  const auto circle = taubin_circle(local.row(0), local.row(1));
  if (!circle) return std::nullopt;
  Cylinder result{axes, *circle, Eigen::VectorXd(points.cols()), local.row(2)};
  for (Index i = 0; i < points.cols(); ++i) {
    result.angle[i] = std::atan2(local(1, i) - circle->y, local(0, i) - circle->x);
  }
  return result;
}

// Turns per height that most of the points agree on, for points in any order: the maximum of
// |sum exp(i (angle - w height))|.
double best_winding(const Cylinder& cylinder) {
  const Index n = cylinder.angle.size(), stride = std::max<Index>(1, n / most_block_means);
  const double range = cylinder.height.maxCoeff() - cylinder.height.minCoeff();
  const double step = 2 * pi / (8 * range);
  const Index most = 2 * std::min(n, most_block_means);  // a quarter turn per point
  double best = -1, winding = 0;
  for (Index k = -most; k <= most; ++k) {
    const double w = step * static_cast<double>(k);
    double real = 0, imaginary = 0;
    for (Index i = 0; i < n; i += stride) {
      const double a = cylinder.angle[i] - w * cylinder.height[i];
      real += std::cos(a);
      imaginary += std::sin(a);
    }
    const double size = std::hypot(real, imaginary);
    if (size > best) {
      best = size;
      winding = w;
    }
  }
  return winding;
}

std::optional<AxisHelix> helix_about(const MeasuredPoints& points, const BlockMeans& blocks,
                                     Vec3 axis) {
  auto cylinder = cylinder_about(points.position, axis);
  if (!cylinder) return std::nullopt;
  AxisHelix helix{cylinder->axes, {}, cylinder->circle.radius, 0, {}};
  if (points.ordered) {
    const Points local = helix.axes.transpose() * blocks.points.position;
    Eigen::VectorXd of_blocks(local.cols());
    for (Index b = 0; b < local.cols(); ++b) {
      of_blocks[b] = std::atan2(local(1, b) - cylinder->circle.y, local(0, b) - cylinder->circle.x);
    }
    helix.phi = unwrapped(cylinder->angle, of_blocks, blocks.of_point);
    if (helix.phi[helix.phi.size() - 1] < helix.phi[0]) {  // arcs grow along the order
      return helix_about(points, blocks, -axis);
    }
  } else {
    const double winding = best_winding(*cylinder);
    const double middle = (cylinder->height.maxCoeff() + cylinder->height.minCoeff()) / 2;
    // where the turns begin is the mean direction of what is left
    double real = 0, imaginary = 0;
    const Eigen::VectorXd guide = winding * (cylinder->height.array() - middle);
    for (Index i = 0; i < guide.size(); ++i) {
      real += std::cos(cylinder->angle[i] - guide[i]);
      imaginary += std::sin(cylinder->angle[i] - guide[i]);
    }
    const double offset = std::atan2(imaginary, real);
    helix.phi.resize(guide.size());
    for (Index i = 0; i < guide.size(); ++i) {
      helix.phi[i] = guide[i] + offset + wrapped(cylinder->angle[i] - guide[i] - offset);
    }
  }
  const double mean_phi = helix.phi.mean(), mean_height = cylinder->height.mean();
  const Eigen::ArrayXd dphi = helix.phi.array() - mean_phi;
  helix.rise = (dphi * (cylinder->height.array() - mean_height)).sum() / dphi.square().sum();
  helix.centre = helix.axes *
                 Vec3(cylinder->circle.x, cylinder->circle.y, mean_height - helix.rise * mean_phi);
  return helix;
}

// Second differences of points in a screw motion are normal to its axis.
Vec3 axis_by_differences(const Points& points, Index lag) {
  const Index n = points.cols() - 2 * lag;
  const Points difference =
      points.rightCols(n) - 2 * points.middleCols(lag, n) + points.leftCols(n);
  return Eigen::SelfAdjointEigenSolver<Mat3>(difference * difference.transpose())
      .eigenvectors()
      .col(0);
}

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
  const Index m = line.cols(), window = std::max<Index>(3, m / 20);
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

}  // namespace

BlockMeans block_means(const MeasuredPoints& points) {
  const Index n = points.count(), count = std::min(n, most_block_means);
  BlockMeans result;
  MeasuredPoints& means = result.points;
  means.ordered = points.ordered;
  means.position = Points::Zero(3, count);
  if (points.arc.size() > 0) means.arc = Eigen::VectorXd::Zero(count);
  if (points.sigma.size() > 0) means.sigma = Eigen::VectorXd::Zero(count);
  Eigen::VectorXd members = Eigen::VectorXd::Zero(count);
  for (Index i = 0; i < n; ++i) {
    const Index b = i * count / n;
    result.of_point.push_back(b);
    means.position.col(b) += points.position.col(i);
    if (points.arc.size() > 0) means.arc[b] += points.arc[i];
    if (points.sigma.size() > 0) means.sigma[b] += points.sigma[i] * points.sigma[i];
    members[b] += 1;
  }
  for (Index b = 0; b < count; ++b) means.position.col(b) /= members[b];
  if (points.arc.size() > 0) means.arc = means.arc.cwiseQuotient(members);
  if (points.sigma.size() > 0) means.sigma = means.sigma.cwiseSqrt().cwiseQuotient(members);
  return result;
}

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

FitStart circle_start(const MeasuredPoints& points) {
  const Mat3 axes = principal_axes(points.position);
  auto cylinder = cylinder_about(points.position, axes.col(2));
  if (!cylinder) return straight_start(points, axes, true);
  const BlockMeans blocks = block_means(points);
  AxisHelix helix{cylinder->axes, {}, cylinder->circle.radius, 0, {}};
  if (points.ordered) {
    const auto wound = helix_about(points, blocks, axes.col(2));
    helix = *wound;
  } else {
    helix.phi = behind_largest_gap(cylinder->angle);
  }
  helix.rise = 0;
  const Vec3 centre = helix.axes.transpose() * points.position.rowwise().mean();
  const Vec3 of_circle = cylinder->axes * Vec3(cylinder->circle.x, cylinder->circle.y, 0);
  helix.centre = of_circle + centre.z() * helix.axes.col(2);
  return start_of(helix, true);
}

std::vector<FitStart> helix_starts(const MeasuredPoints& points) {
  std::vector<FitStart> starts;
  const BlockMeans blocks = block_means(points);
  const auto try_axis = [&](const Vec3& axis) {
    if (const auto helix = helix_about(points, blocks, axis)) {
      starts.push_back(start_of(*helix, false));
    }
  };
  const Mat3 axes = principal_axes(points.position);
  for (int a = 0; a < 3; ++a) try_axis(axes.col(a));
  if (points.ordered) {
    for (Index lag = 1; 3 * lag < blocks.points.count(); lag *= 2) {
      try_axis(axis_by_differences(blocks.points.position, lag));
    }
  }
  const FitStart circle = circle_start(points);
  for (const double torsion : {0.0, 0.5, -0.5}) {
    FitStart start = circle;
    start.basis.planar = false;
    start.shape_unknowns.conservativeResize(3);
    start.shape_unknowns[2] = torsion * circle.shape_unknowns[1];
    starts.push_back(start);
  }
  return starts;
}

SplineStart::SplineStart(const MeasuredPoints& points) {
  const bool known_arcs = points.arc.size() > 0;
  const BlockMeans blocks = block_means(points);
  const Points& means = blocks.points.position;
  const Index last = means.cols() - 1;
  Eigen::VectorXd u = known_arcs ? blocks.points.arc : cumulated_chords(means);
  u /= known_arcs ? points.arc[points.count() - 1] : u[last];
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
  const Points line = on_spline(spline, fine);
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
