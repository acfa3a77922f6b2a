#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <optional>
#include <vector>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// Whether all pivots of a symmetric matrix are positive, `lower`, `smallest` and `order` as in
/// Preconditioner::factored for a matrix of unknown definiteness; the same answer in less memory.
bool is_positive_definite(const Eigen::SparseMatrix<double>& lower, double smallest,
                          const std::vector<int>& order = {});

/// Cholesky factor P = L L^T (up to a fill-reducing permutation) of a curvature model, as a change
/// of variables x = x0 + L^-T y: minimizing over y with the gradient L^-1 g is the preconditioned
/// minimization over x. Factored front by front, in single precision where that serves, with the
/// threads at hand; the same bits for any number of them.
class Preconditioner {
 public:
  /// Whether a matrix is known to be positive definite, but for rounding.
  enum class Definiteness { positive, unknown };
  /// `lower` is the lower triangle of a symmetric matrix, whose eigenvalues should not be below
  /// `smallest` (the shift of a curvature model): it decides whether single precision serves.
  /// Nothing if pivots are not positive. Where those in single precision are not, the matrix is
  /// factored again in double if it is known to be positive definite, and given up if it is not.
  /// `order` (place -> unknown) is that of a factor of a matrix with nearly the same pattern;
  /// without it a new one is found. That takes a part of the time of a factorization, but the order
  /// of a state from which nodes have moved on by the wire's radius makes a much larger factor.
  static std::optional<Preconditioner> factored(const Eigen::SparseMatrix<double>& lower,
                                                double smallest, Definiteness definiteness,
                                                const std::vector<int>& order = {});
  ~Preconditioner();
  Preconditioner(Preconditioner&&) noexcept;
  Preconditioner& operator=(Preconditioner&&) noexcept;

  /// x - x0 = L^-T y.
  void to_step(const Eigen::VectorXd& y, Eigen::VectorXd& step);
  /// Gradient by y from the gradient by x: L^-1 g.
  void to_gradient(const Eigen::VectorXd& by_x, Eigen::VectorXd& by_y);
  /// Nonzeros of the factor.
  double factor_size() const;
  /// In which the unknowns were eliminated: place -> unknown.
  const std::vector<int>& order() const;

 private:
  struct Factor;
  explicit Preconditioner(std::unique_ptr<Factor> factor);
  std::unique_ptr<Factor> factor_;
};

}  // namespace wirepack
