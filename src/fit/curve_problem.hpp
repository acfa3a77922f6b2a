#pragma once

#include <cmath>

#include "wirepack/core/types.hpp"
#include "wirepack/fit/darboux_curve.hpp"
#include "wirepack/fit/measured_points.hpp"

#include "fit_start.hpp"

namespace wirepack {

/// Least squares of the distances of points from a curve. The foot of each point is found anew for
/// every curve, so that the unknowns are those of the curve alone and the gradient is exact; the
/// residuals of a point are its components along d1 and d2 there. With arcs, feet are at those, and
/// the residuals are all three components. All are over sigma where it is given.
struct CurveSolution {
  DarbouxCurve curve;
  Eigen::VectorXd feet;
  Index rows = 2;            ///< residuals of a point
  double cost = 0;           ///< half the sum of squares (of Huber's loss)
  double huber = 0;          ///< bound of Huber's loss on weighted distances; 0: none
  Eigen::MatrixXd jacobian;  ///< of the residuals by the unknowns of the curve
  Eigen::VectorXd distance, weighted_distance;
  Points residual;         ///< from the foot to the point, over sigma
  bool converged = false;  ///< the gradient vanishes to round-off of the residuals

  double first() const { return feet.minCoeff(); }
  double last() const { return feet.maxCoeff(); }
  double length() const { return last() - first(); }
  double rms_distance() const {
    return std::sqrt(distance.squaredNorm() / static_cast<double>(distance.size()));
  }
};

CurveSolution solve_curve(const MeasuredPoints& points, const FitStart& start, double huber = 0,
                          int most_iterations = 200);

/// The start that a solution is.
FitStart continued(const CurveSolution& solution);

}  // namespace wirepack
