#pragma once

#include <vector>

#include "wirepack/core/types.hpp"
#include "wirepack/fit/measured_points.hpp"

#include "fit_start.hpp"

namespace wirepack {

/// The line of a start along ordered points. Smoothed: position as a cubic B-spline of the arc, with as
/// many intervals as Schwarz's criterion wants, for points that scatter. Through points: circles, for
/// few points to a turn.
enum class SplineLine { smoothed, through_points };

/// A smooth curve along ordered points. Only a start, as its curvature is biased where the wire bends
/// tightly, or points scatter.
class SplineStart {
 public:
  SplineStart(const MeasuredPoints& points, SplineLine how);
  /// A start whose k0 is a spline with so many intervals.
  FitStart with_intervals(Index intervals) const;
  /// Of the position; k0 has no finer detail.
  Index intervals() const { return intervals_; }

 private:
  Index intervals_ = 0;
  double length_ = 0;
  Eigen::VectorXd feet_;
  DarbouxCurve::Pose middle_;
  Eigen::VectorXd arcs_;      // of closely spaced samples
  Eigen::Matrix2Xd bending_;  // k1, k2 there, in frames without twist
};

/// Schwarz's criterion for n residuals with a sum of squares and so many unknowns: n ln(sum / n) +
/// unknowns ln n. Sums that round-off makes count as its size; lengths are of order 1.
double schwarz_criterion(double sum_of_squares, Index residuals, Index unknowns);

/// 1, 2, 3, 4, 6, 8, 12, ... up to `most`.
std::vector<Index> interval_ladder(Index most);

}  // namespace wirepack
