#include "helix_starts.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "block_means.hpp"
#include "point_sample.hpp"

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

// The axis of the cylinder that is nearest to the points, from one near it (Gauss and Newton): the
// principal axes of a tight coil are off by more than its turns are apart.
Vec3 nearest_cylinder_axis(const Points& points, Vec3 axis) {
  for (int round = 0; round < 20; ++round) {
    const auto cylinder = cylinder_about(points, axis);
    if (!cylinder) return axis;
    const Points local = cylinder->axes.transpose() * points;
    const double middle = cylinder->height.mean();
    Eigen::Matrix<double, Eigen::Dynamic, 5> by(points.cols(), 5);
    Eigen::VectorXd off(points.cols());
    for (Index i = 0; i < points.cols(); ++i) {
      const double c = std::cos(cylinder->angle[i]), s = std::sin(cylinder->angle[i]);
      const double z = cylinder->height[i] - middle;
      by.row(i) << -z * c, -z * s, -c, -s, -1;  // by a tilt, a shift and the radius
      off[i] = std::hypot(local(0, i) - cylinder->circle.x, local(1, i) - cylinder->circle.y) -
               cylinder->circle.radius;
    }
    const Eigen::VectorXd step = -by.colPivHouseholderQr().solve(off);
    const double tilt = step.head<2>().norm();
    if (!std::isfinite(tilt)) return axis;
    const double limit = std::min(1.0, 0.3 / std::max(tilt, 1e-300));
    axis = (axis + limit * (step[0] * cylinder->axes.col(0) + step[1] * cylinder->axes.col(1)))
               .normalized();
    if (tilt < 1e-12) break;
  }
  return axis;
}

// Axes of cylinders near the points, from all around; none twice.
std::vector<Vec3> cylinder_axes(const Points& points, const Mat3& principal) {
  std::vector<Vec3> axes;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = 0; z <= 1; ++z) {
        const bool twice = z == 0 && (y < 0 || (y == 0 && x <= 0));  // its opposite is there
        if (twice) continue;
        const Vec3 from = principal * Vec3(x, y, z).normalized();
        const Vec3 axis = nearest_cylinder_axis(points, from);
        const bool known = std::any_of(axes.begin(), axes.end(), [&](const Vec3& other) {
          return axis.cross(other).norm() < 1e-6;
        });
        if (!known) axes.push_back(axis);
      }
    }
  }
  return axes;
}

constexpr Index enough_points = 600;

// Turns per height that most of the points agree on, for points in any order: the maximum of
// |sum exp(i (angle - w height))|. Points at equal steps of height agree on others as well, of
// which the least turns are the wire's.
double best_winding(const Cylinder& cylinder) {
  const Index n = cylinder.angle.size();
  const std::vector<Index> which = point_sample(n, enough_points);
  const double range = cylinder.height.maxCoeff() - cylinder.height.minCoeff();
  const double step = 2 * pi / (8 * range);
  const Index most = 2 * std::min<Index>(n, 4000);  // a quarter turn per point
  std::vector<double> size;
  for (Index k = -most; k <= most; ++k) {
    const double w = step * static_cast<double>(k);
    double real = 0, imaginary = 0;
    for (const Index i : which) {
      const double a = cylinder.angle[i] - w * cylinder.height[i];
      real += std::cos(a);
      imaginary += std::sin(a);
    }
    size.push_back(std::hypot(real, imaginary));
  }
  const double best = *std::max_element(size.begin(), size.end());
  Index winding = most + 1;
  for (Index k = -most; k <= most; ++k) {
    const auto at = [&](Index j) {
      return j < -most || j > most ? 0.0 : size[static_cast<std::size_t>(j + most)];
    };
    const bool peak = at(k) >= at(k - 1) && at(k) >= at(k + 1) && at(k) > 0.85 * best;
    if (peak && std::abs(k) < std::abs(winding)) winding = k;
  }
  return step * static_cast<double>(winding);
}

std::optional<AxisHelix> helix_about(const MeasuredPoints& points, const BlockMeans& blocks,
                                     const Vec3& axis) {
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
    if (helix.phi[helix.phi.size() - 1] < helix.phi[0]) {
      // arcs grow along the order, so the axis points the other way
      helix.axes.rightCols<2>() *= -1;
      helix.phi *= -1;
      cylinder->circle.y *= -1;
      cylinder->height *= -1;
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

}  // namespace

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
  std::vector<BlockMeans> guides{block_means(points)};
  // many turns need all points
  if (points.ordered && points.count() > most_block_means) {
    guides.push_back(block_means(points, points.count()));
  }
  const BlockMeans& blocks = guides.front();
  const auto try_axis = [&](const Vec3& axis) {
    for (const BlockMeans& guide : guides) {
      if (const auto helix = helix_about(points, guide, axis)) {
        starts.push_back(start_of(*helix, false));
      }
    }
  };
  const Mat3 axes = principal_axes(points.position);
  for (int a = 0; a < 3; ++a) try_axis(axes.col(a));
  const Points some = points.position(Eigen::all, point_sample(points.count(), enough_points));
  for (const Vec3& axis : cylinder_axes(some, axes)) try_axis(axis);
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

}  // namespace wirepack
