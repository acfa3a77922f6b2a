#pragma once

#include <vector>

#include "wirepack/fit/measured_points.hpp"
#include "wirepack/fit/shape_fit.hpp"

#include "curve_problem.hpp"
#include "listed_points.hpp"
#include "scaled_points.hpp"

namespace wirepack {

/// A curve through points in an order that is given or found.
struct OrderedFit {
  ListedPoints list;
  ScaledPoints scale;
  CurveSolution solution;  ///< in that scale
};

/// The curve nearest to some of the points. Throws InvalidInput where they are in no order that the
/// model can do without.
OrderedFit ordered_fit(const MeasuredPoints& given, const std::vector<Index>& which,
                       const FitOptions& options);

}  // namespace wirepack
