#pragma once

#include "wirepack/core/types.hpp"
#include "wirepack/fit/measured_points.hpp"

#include "fit_start.hpp"

namespace wirepack {

/// A line along ordered points, by closely spaced samples.
struct StartLine {
  Points samples;         ///< 3 x M
  Eigen::VectorXd place;  ///< N, where each of the points is on it, as a share of its length
  Index intervals = 1;    ///< has no finer detail than a spline of so many
};

/// The points' position as a cubic B-spline of the arc, with as many intervals as Schwarz's
/// criterion wants: for points that scatter.
StartLine smoothed_line(const MeasuredPoints& points);
/// Circles through points: for few of them to a turn.
StartLine line_through(const MeasuredPoints& points);

/// A smooth curve along ordered points. Only a start, as its curvature is biased where the wire
/// bends tightly, or points scatter.
class SplineStart {
 public:
  SplineStart(const MeasuredPoints& points, const StartLine& line);
  /// A start whose k0 is a spline with so many intervals.
  FitStart with_intervals(Index intervals) const;

 private:
  double length_ = 0;
  Eigen::VectorXd feet_;
  DarbouxCurve::Pose middle_;
  Eigen::VectorXd arcs_;      // of closely spaced samples
  Eigen::Matrix2Xd bending_;  // k1, k2 there, in frames without twist
};

/// Arcs of the corners of a polyline.
Eigen::VectorXd cumulated_chords(const Points& points);

}  // namespace wirepack
