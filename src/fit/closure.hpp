#pragma once

#include <vector>

#include "wirepack/fit/shape_fit.hpp"

#include "curve_problem.hpp"

namespace wirepack {

/// Whether points go all around a circle or a loop.
struct Closure {
  bool closed = false;
  double gap = 0;  ///< from the last to the first, in lengths of the solution
};

/// `numbers` are those of the shape, in lengths of which `unit` is one of the solution's.
Closure closure_of(ShapeModel model, const CurveSolution& solution,
                   const std::vector<ShapeNumber>& numbers, double unit);

}  // namespace wirepack
