#include "fit_uncertainty.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace wirepack {

Uncertainty uncertainty_of(const MeasuredPoints& points, const CurveSolution& solution) {
  const Index size = solution.jacobian.cols();
  std::vector<Index> free;
  for (Index i = 0; i < size; ++i) {
    if (i != DarbouxCurve::shift_along || solution.rows == 3) free.push_back(i);
  }
  const Eigen::MatrixXd jacobian = solution.jacobian(Eigen::all, free);
  // R of a QR decomposition has the singular values of the Jacobian and few rows.
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(jacobian);
  const Eigen::MatrixXd r = qr.matrixR().topRows(jacobian.cols()).triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(r, Eigen::ComputeFullV);
  const Eigen::MatrixXd directions = qr.colsPermutation() * svd.matrixV();
  const Eigen::VectorXd& values = svd.singularValues();
  Uncertainty result;
  result.unknowns = jacobian.cols();
  result.rank = (values.array() > 1e-9 * values[0]).count();
  result.degrees_of_freedom = jacobian.rows() - result.rank;
  // Huber's proposal: variance of the bounded residuals over the square of their mean derivative,
  // which are the sum of squares and 1 without a bound.
  double squares = 0, derivative = 0;
  for (const double r2 : solution.weighted_distance) {
    const bool far = solution.huber > 0 && r2 > solution.huber;
    squares += far ? solution.huber * solution.huber : r2 * r2;
    derivative += far ? solution.huber / r2 * (1 - 1.0 / static_cast<double>(solution.rows)) : 1;
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
  result.unknown_directions = Eigen::MatrixXd::Zero(size, result.unknowns - kept);
  result.unknown_directions(free, Eigen::all) = directions.rightCols(result.unknowns - kept);
  return result;
}

double robust_scale(const CurveSolution& solution) {
  std::vector<double> sizes(solution.weighted_distance.data(),
                            solution.weighted_distance.data() + solution.weighted_distance.size());
  std::nth_element(sizes.begin(), sizes.begin() + std::ssize(sizes) / 2, sizes.end());
  // medians of |r| for normal r in two and in three dimensions
  return sizes[sizes.size() / 2] / (solution.rows == 2 ? 1.17741 : 1.53817);
}

}  // namespace wirepack
