#pragma once

#include <vector>

#include "wirepack/fit/measured_points.hpp"

#include "curve_problem.hpp"
#include "fit_start.hpp"

namespace wirepack {

/// The curve nearest to points by the best of some starts: all compete on a sample of the points,
/// first for a few steps, then the better ones.
CurveSolution solved_from_best(const MeasuredPoints& points, const std::vector<FitStart>& starts);

}  // namespace wirepack
