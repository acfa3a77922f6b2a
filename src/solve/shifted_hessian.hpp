#pragma once

#include <optional>

#include "wirepack/solve/equilibrium.hpp"
#include "wirepack/solve/preconditioner.hpp"

namespace wirepack {

// Lower triangle of the curvature model at the chart's reference, with the shift of the options on
// its diagonal. `exactness`: see CurvatureModel.
Eigen::SparseMatrix<double> shifted_hessian(const FrameChart& chart, const EnergyTerms& energy,
                                            const EquilibriumOptions& options, double exactness);

// Its factor; nothing where a pivot is not positive. `positive`: known to be positive definite.
// `order`: see Preconditioner::factored.
std::optional<Preconditioner> factored_hessian(const FrameChart& chart,
                                               const Eigen::SparseMatrix<double>& lower,
                                               const EquilibriumOptions& options, bool positive,
                                               const std::vector<int>& order, SolverWork& work);

// Whether it has a factor.
bool is_positive_definite(const FrameChart& chart, const Eigen::SparseMatrix<double>& lower,
                          const EquilibriumOptions& options, const std::vector<int>& order,
                          SolverWork& work);

}  // namespace wirepack
