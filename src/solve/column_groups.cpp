#include "column_groups.hpp"

#include <algorithm>
#include <numeric>

namespace wirepack {

namespace {

using List = std::vector<int>;

std::size_t at(int k) { return static_cast<std::size_t>(k); }

// First columns of the groups, and the end of the last: successive columns of one pattern.
List group_starts(const Eigen::SparseMatrix<double>& lower) {
  const auto n = static_cast<int>(lower.cols());
  const int* const start = lower.outerIndexPtr();
  const int* const row = lower.innerIndexPtr();
  List result;
  for (int c = 0; c < n; ++c) {
    const bool joins = c > 0 && start[c + 1] - start[c] == start[c] - start[c - 1] - 1 &&
                       std::equal(row + start[c], row + start[c + 1], row + start[c - 1] + 1);
    if (!joins) result.push_back(c);
  }
  result.push_back(n);
  return result;
}

// Which groups are coupled, both ways.
Graph group_graph(const Eigen::SparseMatrix<double>& lower, const List& starts) {
  const int groups = static_cast<int>(starts.size()) - 1;
  const List group_of = group_of_columns(starts);
  const auto for_each_edge = [&](auto&& f) {
    for (int g = 0; g < groups; ++g) {
      f(g, g);
      int last = g;
      for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, starts[at(g)]); entry; ++entry) {
        const int other = group_of[at(static_cast<int>(entry.row()))];
        if (other == last) continue;
        f(g, other);
        last = other;
      }
    }
  };
  Graph graph;
  graph.start.assign(at(groups) + 1, 0);
  for_each_edge([&](int a, int b) {
    ++graph.start[at(a) + 1];
    if (b != a) ++graph.start[at(b) + 1];
  });
  std::partial_sum(graph.start.begin(), graph.start.end(), graph.start.begin());
  graph.list.resize(at(graph.start.back()));
  List next(graph.start.begin(), graph.start.end() - 1);
  for_each_edge([&](int a, int b) {
    graph.list[at(next[at(a)]++)] = b;
    if (b != a) graph.list[at(next[at(b)]++)] = a;
  });
  return graph;
}

}  // namespace

ColumnGroups column_groups(const Eigen::SparseMatrix<double>& lower) {
  List starts = group_starts(lower);
  Graph graph = group_graph(lower, starts);
  return {std::move(starts), std::move(graph)};
}

List group_of_columns(const List& start) {
  List group_of(at(start.back()));
  for (int g = 0; g + 1 < static_cast<int>(start.size()); ++g) {
    std::fill(group_of.begin() + start[at(g)], group_of.begin() + start[at(g + 1)], g);
  }
  return group_of;
}

}  // namespace wirepack
