#pragma once

#include "wirepack/core/types.hpp"
#include "wirepack/fit/darboux_curve.hpp"
#include "wirepack/fit/measured_points.hpp"

namespace wirepack {

/// Where a fit begins: a curve and the arc of each point's foot on it.
struct FitStart {
  DarbouxBasis basis;
  DarbouxCurve::Pose pose;         ///< at the middle of the basis
  Eigen::VectorXd shape_unknowns;  ///< of the basis
  Eigen::VectorXd feet;            ///< N
};

/// Arcs of points that are known are those of their feet.
void keep_arcs(const MeasuredPoints& points, FitStart& start);

}  // namespace wirepack
