#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wirepack/core/types.hpp"
#include "wirepack/fit/measured_points.hpp"
#include "wirepack/rod/reference_shape.hpp"

namespace wirepack {

/// Circle: constant k0 without torsion. Helix: constant k0. Spline: k0 varies along the wire.
enum class ShapeModel { circle, helix, spline };

/// A spline has no more.
constexpr Index most_intervals = 96;

struct FitOptions {
  ShapeModel model = ShapeModel::helix;
  bool robust = false;  ///< Huber's loss: points far off count by their distance, not its square
  std::optional<Index> intervals;  ///< of the spline; chosen by Schwarz's criterion when not given
};

/// A number of the shape. Of a spline, curvature and torsion are means along the wire.
struct ShapeNumber {
  std::string name;
  double value = 0, standard_error = 0;
  bool fixed = false;      ///< by the model
  bool determined = true;  ///< false: the points do not tell it
};

/// A shape fitted to points, and how well they tell it.
struct ShapeFit {
  ShapeModel model = ShapeModel::helix;
  ReferenceShape shape;              ///< k0 from arc 0 at the first point to the last one
  std::vector<ShapeNumber> numbers;  ///< curvature, torsion; radius and pitch unless a spline
  Eigen::MatrixXd correlation;       ///< of the numbers; 0 where one is fixed or not determined
  double length = 0;                 ///< of wire that the points cover [length]
  Index intervals = 0;               ///< of the spline
  Index unknowns = 0, rank = 0;      ///< of the fit; a lower rank leaves some undetermined
  Index degrees_of_freedom = 0;
  double residual_rms = 0;  ///< of the distances of the points that are not left out [length]
  double noise = 0;         ///< standard deviation of a coordinate: from the distances,
                            ///< over the given sigma where there is one
  std::optional<double> chi_square;  ///< where sigmas are given
  Eigen::VectorXd arc;               ///< N, of the foot of each point, from the first one
  Eigen::VectorXd distance;          ///< N, from the curve [length]
  std::vector<Index> outliers;       ///< less than one of them is expected in 20 such fits
  std::vector<Index> left_out;       ///< outliers far from all others, or their neighbours
  std::string misfit;                ///< how the points show that the model is not theirs, or empty
  bool planar = false;               ///< the points scatter in a plane only, and so do the errors
  bool converged = false;
  bool closed = false;  ///< the points go all around; in no given order, so does the length
  Points curve;         ///< the fitted curve, closely spaced, for drawing
};

/// Least squares of the distances of points from the centreline of a rod (at their arcs, where arcs
/// are given), with k0 the unknown; starting values and the order of points are found on the way:
/// that of the list where it goes along a wire. Standard errors are those of the linearised fit, by
/// the given sigmas or else by the variance of the residuals. Points times a factor give the shape
/// times that factor.
///
/// Throws InvalidInput when the points cannot determine the model: too few of them, all in one
/// place, no order along a wire, turns of either hand that fit alike, arcs shorter than chords.
ShapeFit fit_shape(const MeasuredPoints& points, const FitOptions& options);

}  // namespace wirepack
