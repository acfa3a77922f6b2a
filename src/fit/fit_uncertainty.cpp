#include "fit_uncertainty.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace wirepack {

namespace {

// Normal of the plane in which the points lie far better than they lie on the curve.
std::optional<Vec3> plane_of(const MeasuredPoints& points, const CurveSolution& solution) {
  const Points centred = points.position.colwise() - points.position.rowwise().mean();
  const Eigen::JacobiSVD<Points> axes(centred, Eigen::ComputeThinU);
  const Vec3 normal = axes.matrixU().col(2);
  const double out_of_plane = (normal.transpose() * centred).norm();
  if (!(out_of_plane < 0.02 * solution.distance.norm())) return std::nullopt;
  return normal;
}

// Rows of the Jacobian for residuals along the normal of the curve in the plane (and along its
// tangent, where arcs are known).
Eigen::MatrixXd rows_in_plane(const CurveSolution& solution, const Vec3& normal) {
  const Index rows = solution.rows, n = solution.distance.size();
  Eigen::MatrixXd result((rows - 1) * n, solution.jacobian.cols());
  for (Index i = 0; i < n; ++i) {
    const Mat3 directors = solution.curve.at(solution.feet[i]).directors;
    const Vec3 across = directors.transpose() * normal.cross(directors.col(2)).normalized();
    result.row((rows - 1) * i) =
        across.head<2>().transpose() * solution.jacobian.middleRows(rows * i, 2);
    if (rows == 3) result.row(2 * i + 1) = solution.jacobian.row(3 * i + 2);
  }
  return result;
}

// Of those of a basis: a tilt, a shift, and the parts of k0 that lead out of the plane.
Index unknowns_out_of_plane(const DarbouxBasis& basis) {
  return 2 + basis.size() - (basis.intervals > 0 ? basis.intervals + 3 : 1);
}

double quantile_scale(const CurveSolution& solution, double share, double of_unit_normal) {
  std::vector<double> sizes(solution.weighted_distance.data(),
                            solution.weighted_distance.data() + solution.weighted_distance.size());
  const auto place = sizes.begin() + static_cast<Index>(share * static_cast<double>(sizes.size()));
  std::nth_element(sizes.begin(), place, sizes.end());
  return *place / of_unit_normal;
}

}  // namespace

Uncertainty uncertainty_of(const MeasuredPoints& points, const CurveSolution& solution) {
  Uncertainty result;
  const std::optional<Vec3> plane = plane_of(points, solution);
  result.planar = plane.has_value();
  result.dimensions = result.planar ? solution.rows - 1 : solution.rows;
  const Index size = solution.jacobian.cols();
  std::vector<Index> free;
  for (Index i = 0; i < size; ++i) {
    if (i != DarbouxCurve::shift_along || solution.rows == 3) free.push_back(i);
  }
  const Eigen::MatrixXd jacobian =
      plane ? Eigen::MatrixXd(rows_in_plane(solution, *plane)(Eigen::all, free))
            : Eigen::MatrixXd(solution.jacobian(Eigen::all, free));
  // R of a QR decomposition has the singular values of the Jacobian and few rows.
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(jacobian);
  const Eigen::MatrixXd r = qr.matrixR().topRows(jacobian.cols()).triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(r, Eigen::ComputeFullV);
  const Eigen::MatrixXd directions = qr.colsPermutation() * svd.matrixV();
  const Eigen::VectorXd& values = svd.singularValues();
  result.unknowns = jacobian.cols() - (plane ? unknowns_out_of_plane(solution.curve.basis()) : 0);
  // what leads out of a plane that points are rounded to is hardly above nothing
  result.rank = std::min<Index>((values.array() > 1e-9 * values[0]).count(), result.unknowns);
  result.degrees_of_freedom = jacobian.rows() - result.rank;
  // Huber's proposal: variance of the bounded residuals over the square of their mean derivative,
  // which are the sum of squares and 1 without a bound.
  double squares = 0, derivative = 0;
  for (const double r2 : solution.weighted_distance) {
    const bool far = solution.huber > 0 && r2 > solution.huber;
    squares += far ? solution.huber * solution.huber : r2 * r2;
    derivative +=
        far ? solution.huber / r2 * (1 - 1.0 / static_cast<double>(result.dimensions)) : 1;
  }
  derivative /= static_cast<double>(points.count());
  const double rounding = 1e-16;  // of points in units of their extent
  const double variance = squares /
                          static_cast<double>(std::max<Index>(result.degrees_of_freedom, 1)) /
                          (derivative * derivative);
  const bool given = points.sigma.size() > 0;
  result.noise = given ? std::sqrt(variance) : std::max(std::sqrt(variance), rounding);
  const double scale = given && !(solution.huber > 0) ? 1 : result.noise;
  const Index kept = result.rank;
  const Eigen::MatrixXd half =
      directions.leftCols(kept) * values.head(kept).cwiseInverse().asDiagonal();
  const Eigen::MatrixXd of_free = scale * scale * (half * half.transpose());
  result.covariance = Eigen::MatrixXd::Zero(size, size);
  result.covariance(free, free) = of_free;
  result.unknown_directions = Eigen::MatrixXd::Zero(size, jacobian.cols() - kept);
  result.unknown_directions(free, Eigen::all) = directions.rightCols(jacobian.cols() - kept);
  return result;
}

double median_scale(const CurveSolution& solution, Index dimensions) {
  constexpr std::array<double, 3> of_normal{0.67449, 1.17741, 1.53817};  // medians of chi
  return quantile_scale(solution, 0.5, of_normal[static_cast<std::size_t>(dimensions - 1)]);
}

double upper_scale(const CurveSolution& solution, Index dimensions) {
  constexpr std::array<double, 3> of_normal{1.28155, 1.79412, 2.15444};  // chi, 80 %
  return quantile_scale(solution, 0.8, of_normal[static_cast<std::size_t>(dimensions - 1)]);
}

}  // namespace wirepack
