#include "shifted_hessian.hpp"

namespace wirepack {

namespace {

// A radian counts as the length that the tolerances give it.
double angle_shift(const EquilibriumOptions& options) {
  const double radian = options.moment_tolerance / options.force_tolerance;
  return options.shift * radian * radian;
}

// Shift that stands to the mean of the diagonal as the shifts of places and of angles stand, in the
// mean, to their diagonals: places and angles have other units, and only such ratios know none.
double typical_shift(const FrameChart& chart, const Eigen::SparseMatrix<double>& lower,
                     const EquilibriumOptions& options) {
  const Eigen::VectorXd diagonal = lower.diagonal();
  double ratios = 0;
  for (Index b = 0; b < chart.block_count(); ++b) {
    for (int c = 0; c < 4; ++c) {
      const Index u = chart.unknown(b, c);
      if (u >= 0) ratios += diagonal[u] / (c < 3 ? options.shift : angle_shift(options));
    }
  }
  return diagonal.sum() / ratios;
}

}  // namespace

Eigen::SparseMatrix<double> shifted_hessian(const FrameChart& chart, const EnergyTerms& energy,
                                            const EquilibriumOptions& options, double exactness) {
  CurvatureModel model(chart, exactness);
  energy.add_curvature(chart.reference(), model);
  return model.lower_triangle(options.shift, angle_shift(options));
}

std::optional<Preconditioner> factored_hessian(const FrameChart& chart,
                                               const Eigen::SparseMatrix<double>& lower,
                                               const EquilibriumOptions& options, bool positive,
                                               const std::vector<int>& order, SolverWork& work) {
  ++work.factorizations;
  const auto definiteness =
      positive ? Preconditioner::Definiteness::positive : Preconditioner::Definiteness::unknown;
  return Preconditioner::factored(lower, typical_shift(chart, lower, options), definiteness, order);
}

bool is_positive_definite(const FrameChart& chart, const Eigen::SparseMatrix<double>& lower,
                          const EquilibriumOptions& options, const std::vector<int>& order,
                          SolverWork& work) {
  ++work.factorizations;
  return is_positive_definite(lower, typical_shift(chart, lower, options), order);
}

}  // namespace wirepack
