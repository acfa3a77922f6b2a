#pragma once

#include "wirepack/core/types.hpp"
#include "wirepack/fit/measured_points.hpp"

#include "curve_problem.hpp"

namespace wirepack {

/// Covariance of the unknowns (with those of the pose), and what of them the points do not tell.
struct Uncertainty {
  Eigen::MatrixXd covariance;
  Eigen::MatrixXd unknown_directions;
  Index rank, unknowns, degrees_of_freedom;
  double noise;
};

/// Of the linearised fit: by the given sigmas, or by the variance of the residuals.
Uncertainty uncertainty_of(const MeasuredPoints& points, const CurveSolution& solution);

/// Standard deviation of a coordinate (over the sigmas where there are any) by the median of the distances,
/// which points that are far off move little.
double robust_scale(const CurveSolution& solution);

}  // namespace wirepack
