#pragma once

#include <Eigen/SparseCore>
#include <optional>

#include "elimination_tree.hpp"

namespace wirepack {

/// Columns of a Cholesky factor, front by front: those of front f start at `start[f]`, each with an
/// entry for every column of the front (those above the diagonal mean nothing) and every row below.
template <class Entry>
struct FrontColumns {
  std::vector<Index> start;
  Eigen::Matrix<Entry, Eigen::Dynamic, 1> entries;
};

/// Multifrontal factorization (Duff and Reid 1983): each front takes in what its children leave for
/// the rows below them, eliminates its columns and leaves the rest to its parent. Computed in
/// Entry's precision; the same bits for any number of threads. Nothing if a pivot is not positive.
template <class Entry>
std::optional<FrontColumns<Entry>> factored(const EliminationTree& tree,
                                            const Eigen::SparseMatrix<double>& lower);

/// Whether all pivots are positive. Keeps no columns of the factor.
template <class Entry>
bool has_positive_pivots(const EliminationTree& tree, const Eigen::SparseMatrix<double>& lower);

extern template std::optional<FrontColumns<float>> factored(const EliminationTree&,
                                                            const Eigen::SparseMatrix<double>&);
extern template std::optional<FrontColumns<double>> factored(const EliminationTree&,
                                                             const Eigen::SparseMatrix<double>&);
extern template bool has_positive_pivots<float>(const EliminationTree&,
                                                const Eigen::SparseMatrix<double>&);
extern template bool has_positive_pivots<double>(const EliminationTree&,
                                                 const Eigen::SparseMatrix<double>&);

}  // namespace wirepack
