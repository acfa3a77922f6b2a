#pragma once

#include <vector>

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

/// Means of runs of successive points: less scatter, and an order that it does not disturb.
struct BlockMeans {
  MeasuredPoints points;        ///< at most most_block_means; as many as there are of fewer points
  std::vector<Index> of_point;  ///< the mean that each point is in
};
constexpr Index most_block_means = 600;
BlockMeans block_means(const MeasuredPoints& points);

/// The algebraic circle (Taubin 1991) in the plane of the points, or a straight line.
FitStart circle_start(const MeasuredPoints& points);

/// Helices around several possible axes, with the circle, and the circle with some torsion of either
/// hand for short arcs; one of them is near the best fit.
std::vector<FitStart> helix_starts(const MeasuredPoints& points);

/// A smooth curve through ordered points: position as a cubic B-spline of the arc, with as many
/// intervals as Schwarz's criterion wants. Only a start, as its curvature is biased where the wire
/// bends tightly.
class SplineStart {
 public:
  explicit SplineStart(const MeasuredPoints& points);
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
