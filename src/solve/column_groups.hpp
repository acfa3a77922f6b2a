#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

namespace wirepack {

/// A graph by the neighbors of each vertex, itself among them and sorted: those of v are
/// list[start[v]] ... list[start[v + 1] - 1].
struct Graph {
  std::vector<int> start, list;

  int size() const { return static_cast<int>(start.size()) - 1; }
  template <class F>
  void for_each_neighbor(int v, F&& f) const {
    const auto vertex = static_cast<std::size_t>(v);
    for (int k = start[vertex]; k < start[vertex + 1]; ++k) f(list[static_cast<std::size_t>(k)]);
  }
};

/// Groups of successive columns of one pattern: the unknowns of a node are coupled to the same
/// others, so the groups are few.
struct ColumnGroups {
  std::vector<int> start;  ///< first column of each group, and the end of the last
  Graph graph;             ///< which groups are coupled, both ways

  int size() const { return graph.size(); }
  int width(int group) const {
    const auto g = static_cast<std::size_t>(group);
    return start[g + 1] - start[g];
  }
};

/// `lower`: a lower triangle with sorted columns.
ColumnGroups column_groups(const Eigen::SparseMatrix<double>& lower);

/// The group of each column, from the groups' starts.
std::vector<int> group_of_columns(const std::vector<int>& start);

}  // namespace wirepack
