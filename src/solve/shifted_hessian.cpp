#include "shifted_hessian.hpp"

#include <algorithm>

namespace wirepack {

namespace {

// A radian counts as the length that the tolerances give it.
double angle_shift(const EquilibriumOptions& options) {
  const double radian = options.moment_tolerance / options.force_tolerance;
  return options.shift * radian * radian;
}

}  // namespace

Eigen::SparseMatrix<double> shifted_hessian(const FrameChart& chart, const EnergyTerms& energy,
                                            const EquilibriumOptions& options, double exactness) {
  CurvatureModel model(chart, exactness);
  energy.add_curvature(chart.reference(), model);
  return model.lower_triangle(options.shift, angle_shift(options));
}

std::optional<Preconditioner> factored_hessian(const Eigen::SparseMatrix<double>& lower,
                                               const EquilibriumOptions& options, bool positive,
                                               SolverWork& work) {
  ++work.factorizations;
  const auto definiteness =
      positive ? Preconditioner::Definiteness::positive : Preconditioner::Definiteness::unknown;
  return Preconditioner::factored(lower, std::min(options.shift, angle_shift(options)),
                                  definiteness);
}

}  // namespace wirepack
