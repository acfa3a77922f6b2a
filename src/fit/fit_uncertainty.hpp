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
  Index dimensions;  ///< in which a point can be off its place on the curve: 1 to 3
  bool planar;       ///< points and scatter are in one plane, as in a picture
};

/// Of the linearised fit: by the given sigmas, or by the variance of the residuals. Of planar
/// points only the residuals in the plane, and the unknowns that they depend on, count.
Uncertainty uncertainty_of(const MeasuredPoints& points, const CurveSolution& solution);

/// Standard deviation of a coordinate (over the sigmas where there are any) by the median of the
/// distances in so many dimensions, which points that are far off move little.
double median_scale(const CurveSolution& solution, Index dimensions);

/// The same by the distance that four in five points do not exceed: for residuals of which most are
/// none, as of points that are rounded.
double upper_scale(const CurveSolution& solution, Index dimensions);

}  // namespace wirepack
