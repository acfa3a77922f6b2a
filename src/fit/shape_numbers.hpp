#pragma once

#include <vector>

#include "wirepack/fit/shape_fit.hpp"

#include "curve_problem.hpp"
#include "fit_uncertainty.hpp"

namespace wirepack {

struct ShapeNumbers {
  std::vector<ShapeNumber> numbers;
  Eigen::MatrixXd correlation;  ///< 0 where a number is fixed or not determined
};

/// Numbers of a fitted shape between two arcs, with their errors, in lengths of which `unit` is one
/// of the solution's. Those that the points do not tell are marked.
ShapeNumbers shape_numbers(ShapeModel model, const CurveSolution& solution,
                           const Uncertainty& uncertainty, double first, double last, double unit);

}  // namespace wirepack
