#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// Neighbouring columns of a Cholesky factor that are eliminated together and have the same rows
/// below their triangle. Numbers are places in the order of elimination.
struct Front {
  Index first_column, columns;
  std::vector<int> rows;  ///< below the columns, in growing order
  int parent;             ///< the front that has the first of its rows; -1: it has none
};

/// How a sparse symmetric matrix is eliminated: order of the unknowns, and the fronts of its
/// factor, each of which waits for its children alone. Some subtrees, which share no column, are
/// told apart, so that threads can take one each; the split depends on the matrix alone.
struct EliminationTree {
  std::vector<int> order;                  ///< place in the elimination -> unknown
  std::vector<Front> fronts;               ///< children before their parents
  std::vector<std::vector<int>> children;  ///< of each front
  std::vector<std::vector<int>>
      subtrees;          ///< whole ones, the costliest first; fronts of each in order
  std::vector<int> top;  ///< the fronts above the subtrees, in order
};

/// `lower` is a lower triangle with sorted columns. Its unknowns are eliminated in the given order
/// (place -> unknown), that of a matrix with nearly the same pattern, or else in one of their own
/// (elimination_order). Fronts that follow on each other are taken together where that adds few
/// zeros.
EliminationTree elimination_tree(const Eigen::SparseMatrix<double>& lower,
                                 const std::vector<int>& unknowns = {});

}  // namespace wirepack
