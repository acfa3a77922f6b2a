#include "elimination_tree.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "column_groups.hpp"
#include "elimination_order.hpp"

namespace wirepack {

namespace {

using List = std::vector<int>;

std::size_t at(int k) { return static_cast<std::size_t>(k); }

// The groups in the order of their first unknowns.
List groups_in(const List& unknowns, const ColumnGroups& groups) {
  const List group_of = group_of_columns(groups.start);
  std::vector<bool> placed(at(groups.size()), false);
  List order;
  for (const int unknown : unknowns) {
    const int group = group_of[at(unknown)];
    if (placed[at(group)]) continue;
    placed[at(group)] = true;
    order.push_back(group);
  }
  return order;
}

// Liu's elimination tree: the parent of a vertex is the first later one that it is coupled to when
// all before it are eliminated; -1 for a root.
List parents_in(const List& order, const Graph& graph) {
  const int n = graph.size();
  List place(at(n)), parent(at(n), -1), ancestor(at(n), -1);
  for (int k = 0; k < n; ++k) place[at(order[at(k)])] = k;
  for (int k = 0; k < n; ++k) {
    graph.for_each_neighbor(order[at(k)], [&](int neighbor) {
      int i = place[at(neighbor)];
      while (i >= 0 && i < k) {
        const int next = std::exchange(ancestor[at(i)], k);
        if (next < 0) parent[at(i)] = k;
        if (next == k) break;
        i = next;
      }
    });
  }
  return parent;
}

// Places in an order in which every vertex comes right after its subtrees.
List postorder(const List& parent) {
  const int n = static_cast<int>(parent.size());
  List first_child(at(n), -1), sibling(at(n), -1), result, path;
  for (int k = n - 1; k >= 0; --k) {
    if (parent[at(k)] < 0) continue;
    sibling[at(k)] = std::exchange(first_child[at(parent[at(k)])], k);
  }
  for (int root = 0; root < n; ++root) {
    if (parent[at(root)] >= 0) continue;
    path.push_back(root);
    while (!path.empty()) {
      const int child = first_child[at(path.back())];
      if (child >= 0) {
        first_child[at(path.back())] = sibling[at(child)];
        path.push_back(child);
      } else {
        result.push_back(path.back());
        path.pop_back();
      }
    }
  }
  return result;
}

// Another order with the same fill, in which every vertex comes right after its subtrees.
void put_subtrees_together(List& order, List& parent) {
  const List by_subtrees = postorder(parent), old_order = order, old_parent = parent;
  List place(order.size());
  for (std::size_t k = 0; k < place.size(); ++k) place[at(by_subtrees[k])] = static_cast<int>(k);
  for (std::size_t k = 0; k < place.size(); ++k) {
    const std::size_t old = at(by_subtrees[k]);
    order[k] = old_order[old];
    parent[k] = old_parent[old] < 0 ? -1 : place[at(old_parent[old])];
  }
}

// Of each vertex, in the order of elimination: those after it that it is coupled to when its turn
// comes.
std::vector<List> fill_patterns(const List& order, const List& parent, const Graph& graph) {
  const int n = graph.size();
  List place(at(n)), seen(at(n), -1);
  for (int k = 0; k < n; ++k) place[at(order[at(k)])] = k;
  std::vector<List> pattern(at(n));
  for (int k = 0; k < n; ++k) {
    List& own = pattern[at(k)];  // holds what its children have handed on
    std::size_t kept = 0;
    const auto is_new = [&](int i) { return i > k && std::exchange(seen[at(i)], k) != k; };
    for (const int i : own) {
      if (is_new(i)) own[kept++] = i;
    }
    own.resize(kept);
    graph.for_each_neighbor(order[at(k)], [&](int neighbor) {
      if (is_new(place[at(neighbor)])) own.push_back(place[at(neighbor)]);
    });
    if (parent[at(k)] >= 0) {
      List& handed = pattern[at(parent[at(k)])];
      handed.insert(handed.end(), own.begin(), own.end());
    }
  }
  return pattern;
}

// Successive vertices whose columns are one front.
struct Run {
  int first, last;
  double columns, rows;  // rows: below the last column
  double zeros;          // entries that are there for the sake of one front
};

// Wide fronts are worth some zeros: more, in proportion, where they are small.
bool worth_it(const Run& run) {
  const double part = run.columns <= 12    ? 1
                      : run.columns <= 48  ? 0.5
                      : run.columns <= 144 ? 0.12
                                           : 0.05;
  return run.zeros < part * run.columns * ((run.columns + 1) / 2 + run.rows);
}

std::vector<Run> runs_of(const List& parent, const std::vector<List>& pattern,
                         const List& width_of) {
  std::vector<Run> runs;
  for (int k = 0; k < static_cast<int>(parent.size()); ++k) {
    double rows = 0;
    for (const int i : pattern[at(k)]) rows += width_of[at(i)];
    Run run{k, k, static_cast<double>(width_of[at(k)]), rows, 0};
    while (!runs.empty() && parent[at(runs.back().last)] == run.first) {
      const Run& before = runs.back();
      const double added = before.columns * (run.columns + run.rows - before.rows);
      const Run both{before.first, k, before.columns + run.columns, rows,
                     before.zeros + run.zeros + added};
      if (!worth_it(both)) break;
      run = both;
      runs.pop_back();
    }
    runs.push_back(run);
  }
  return runs;
}

double elimination_work(const Front& front) {
  const auto w = static_cast<double>(front.columns), m = static_cast<double>(front.rows.size());
  return w * (w * w / 3 + w * m + m * m);
}

// Whole subtrees with a small part of the work, and the rest.
void split(EliminationTree& tree) {
  const auto n = static_cast<int>(tree.fronts.size());
  std::vector<double> work(at(n), 0);  // of the subtree below each front
  double total = 0;
  for (int f = 0; f < n; ++f) {
    const Front& front = tree.fronts[at(f)];
    total += elimination_work(front);
    work[at(f)] += elimination_work(front);
    if (front.parent >= 0) work[at(front.parent)] += work[at(f)];
  }
  List root(at(n), -1), roots;
  for (int f = n - 1; f >= 0; --f) {
    const int parent = tree.fronts[at(f)].parent;
    if (parent >= 0) root[at(f)] = root[at(parent)];
    if (root[at(f)] >= 0 || work[at(f)] > total / 12) continue;
    root[at(f)] = f;
    roots.push_back(f);
  }
  std::stable_sort(roots.begin(), roots.end(),
                   [&](int a, int b) { return work[at(a)] > work[at(b)]; });
  List number(at(n), -1);
  for (std::size_t r = 0; r < roots.size(); ++r) number[at(roots[r])] = static_cast<int>(r);
  tree.subtrees.resize(roots.size());
  for (int f = 0; f < n; ++f) {
    List& place = root[at(f)] < 0 ? tree.top : tree.subtrees[at(number[at(root[at(f)])])];
    place.push_back(f);
  }
}

}  // namespace

EliminationTree elimination_tree(const Eigen::SparseMatrix<double>& lower, const List& unknowns) {
  const ColumnGroups groups = column_groups(lower);
  const List& starts = groups.start;
  const Graph& graph = groups.graph;
  const int n = graph.size();
  const bool fits = static_cast<Index>(unknowns.size()) == lower.cols();
  List order = fits ? groups_in(unknowns, groups) : elimination_order(groups);
  List parent = parents_in(order, graph);
  put_subtrees_together(order, parent);
  const std::vector<List> pattern = fill_patterns(order, parent, graph);

  EliminationTree tree;
  List width_of(at(n)), first_column{0}, front_of(at(n));
  for (int k = 0; k < n; ++k) {
    const int group = order[at(k)];
    width_of[at(k)] = groups.width(group);
    first_column.push_back(first_column.back() + width_of[at(k)]);
    for (int c = starts[at(group)]; c < starts[at(group) + 1]; ++c) tree.order.push_back(c);
  }
  const std::vector<Run> runs = runs_of(parent, pattern, width_of);
  for (const Run& run : runs) {
    const auto number = static_cast<int>(tree.fronts.size());
    std::fill(front_of.begin() + run.first, front_of.begin() + run.last + 1, number);
    Front front{first_column[at(run.first)], static_cast<Index>(run.columns), {}, -1};
    List below = pattern[at(run.last)];
    std::sort(below.begin(), below.end());
    for (const int k : below) {
      for (int c = first_column[at(k)]; c < first_column[at(k) + 1]; ++c) front.rows.push_back(c);
    }
    tree.fronts.push_back(std::move(front));
  }
  tree.children.resize(runs.size());
  for (std::size_t f = 0; f < runs.size(); ++f) {
    const int above = parent[at(runs[f].last)];
    if (above < 0) continue;
    tree.fronts[f].parent = front_of[at(above)];
    tree.children[at(front_of[at(above)])].push_back(static_cast<int>(f));
  }
  split(tree);
  return tree;
}

}  // namespace wirepack
