#pragma once

#include <functional>
#include <optional>

#include "curve_problem.hpp"
#include "spline_start.hpp"

namespace wirepack {

/// Wires that wind less are fitted in one piece.
constexpr double fewest_turns_of_parts = 8;

struct LineOfParts {
  StartLine line;
  double turns;  ///< of the tangent, and of its scatter
};

/// The line along ordered points of a wire that winds often: curves through parts of a few turns
/// that overlap by half, each one blended into the next. Errors of k0 add up along a curve: through
/// all turns at once, a start from the points themselves ends on wrong ones. Nothing where the
/// points wind less, or where a part has no curve.
std::optional<LineOfParts> line_of_parts(
    const MeasuredPoints& points,
    const std::function<CurveSolution(const MeasuredPoints&)>& curve_through);

}  // namespace wirepack
