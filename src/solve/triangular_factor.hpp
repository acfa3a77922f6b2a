#pragma once

#include <Eigen/Core>

#include "multifrontal.hpp"

namespace wirepack {

/// Lower triangular factor L of a permuted matrix, for its two solves. Entries may be in single
/// precision (half the memory traffic), sums are in double, so that both solves are exactly each
/// other's transpose.
template <class Entry>
class TriangularFactor {
 public:
  TriangularFactor(EliminationTree tree, FrontColumns<Entry> factor);

  /// Replaces v, in the order of elimination, by L^-1 v.
  void solve(Eigen::VectorXd& v);
  /// Replaces v by L^-T v.
  void solve_transposed(Eigen::VectorXd& v);

 private:
  // Fronts that one thread works on, one after the other.
  struct Part {
    std::vector<int> fronts;
    std::vector<int> rows_outside;  // of a subtree: those that its fronts share with fronts above
    Index copy = 0;                 // where its own copy of them starts
    Eigen::VectorXd work;           // as many as a front of it has rows
  };
  // A front as its solves see it.
  struct Columns {
    Index w, m, height;  // columns, rows below them, both
    const Entry* entry;  // of the first column, at its diagonal
    double* x;           // the unknowns of the columns
    const double* inverse;
    const int* row;  // places of the rows below
    bool shared;     // whether threads may take parts of it
  };
  Columns columns_of(int front, const Part& part);
  bool is_large() const;
  void forward(Part& part);
  void backward(Part& part);

  std::vector<Front> fronts_;  // rows outside of a subtree are those of its copy
  FrontColumns<Entry> factor_;
  std::vector<Part> subtrees_;
  Part top_;
  Eigen::VectorXd inverse_diagonal_;
  Eigen::VectorXd values_;  // the unknowns, then the copies of the subtrees
};

extern template class TriangularFactor<float>;
extern template class TriangularFactor<double>;

}  // namespace wirepack
