#pragma once

#include <Eigen/Core>
#include <cholmod.h>
#include <vector>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// Lower triangular factor L of a permuted matrix, in panels: a few columns with the same rows below
/// their triangle, parts of a supernode of CHOLMOD's factor. Laid out for its two solves alone, which
/// read every entry once: entries are kept in single precision where that is good enough (half the
/// memory traffic) and computed with in double, so that both solves are exactly each other's transpose.
template <class Entry>
class TriangularFactor {
 public:
  explicit TriangularFactor(const cholmod_factor& factor);

  /// Replaces v, in the order of the factor, by L^-1 v.
  void solve(Eigen::VectorXd& v);
  /// Replaces v by L^-T v.
  void solve_transposed(Eigen::VectorXd& v);

 private:
  struct Panel {
    Index first_column, columns, rows_below;
    std::size_t triangle, below, row_list;  ///< where their parts start
  };
  std::vector<Panel> panels_;
  std::vector<int> rows_;        ///< below the triangle, panel by panel
  std::vector<Entry> triangle_;  ///< strictly below the diagonal, by columns
  std::vector<Entry> below_;     ///< rows below the triangle, by columns
  Eigen::VectorXd inverse_diagonal_;
  std::vector<double> work_;
};

extern template class TriangularFactor<float>;
extern template class TriangularFactor<double>;

}  // namespace wirepack
