#pragma once

#include <vector>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// Numbers of intervals to try of a spline: 1, 2, 3, 4, 6, 8, 12, ... up to `most`, and to
/// most_intervals.
std::vector<Index> interval_ladder(Index most);

/// Schwarz's criterion for n residuals with a sum of squares and so many unknowns: n ln(sum / n) +
/// unknowns ln n. Sums that round-off makes count as its size; lengths are of order 1.
double schwarz_criterion(double sum_of_squares, Index residuals, Index unknowns);

}  // namespace wirepack
