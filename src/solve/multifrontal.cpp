#include "multifrontal.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <atomic>
#include <numeric>

#include "wirepack/core/threads.hpp"

namespace wirepack {

namespace {

// Columns of a front that are eliminated at a time, and rows or columns that a thread takes at a
// time: fixed, as the sums of a product depend on its size.
constexpr Index block_columns = 48;
constexpr Index tile = 96;
// Memory is Eigen's throughout, for it is aligned: small products of Eigen start their lanes at an
// aligned place, so that their rounding would depend on where the heap had room.

// The lower triangle of the matrix in the order of elimination; rows of a column are not sorted.
template <class Entry>
struct OrderedLower {
  std::vector<int> start, row;
  std::vector<Entry> value;
};

template <class Entry>
OrderedLower<Entry> in_order(const Eigen::SparseMatrix<double>& lower,
                             const std::vector<int>& order) {
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    place[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  }
  const auto for_each_entry = [&](auto&& f) {
    for (Index c = 0; c < lower.cols(); ++c) {
      const int p = place[static_cast<std::size_t>(c)];
      for (Eigen::SparseMatrix<double>::InnerIterator entry(lower, c); entry; ++entry) {
        const int q = place[static_cast<std::size_t>(entry.row())];
        f(std::min(p, q), std::max(p, q), entry.value());
      }
    }
  };
  OrderedLower<Entry> result;
  result.start.assign(order.size() + 1, 0);
  for_each_entry([&](int c, int, double) { ++result.start[static_cast<std::size_t>(c) + 1]; });
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
  std::vector<int> next(result.start.begin(), result.start.end() - 1);
  result.row.resize(static_cast<std::size_t>(lower.nonZeros()));
  result.value.resize(result.row.size());
  for_each_entry([&](int c, int r, double value) {
    const auto k = static_cast<std::size_t>(next[static_cast<std::size_t>(c)]++);
    result.row[k] = r;
    result.value[k] = static_cast<Entry>(value);
  });
  return result;
}

template <class Entry>
class Elimination {
 public:
  // `factor`: where columns are kept; null if pivots are all that is asked for.
  Elimination(const EliminationTree& tree, const OrderedLower<Entry>& lower,
              FrontColumns<Entry>* factor)
      : tree_(&tree), lower_(&lower), factor_(factor), updates_(tree.fronts.size()) {}

  // Whether all pivots are positive.
  bool run() {
    std::atomic<bool> positive = true;
    const auto take = [&](const std::vector<int>& fronts) {
      Scratch scratch{std::vector<int>(tree_->order.size()), {}};
      for (const int f : fronts) {
        if (positive && !eliminate(f, scratch)) positive = false;
      }
    };
    for_each_tile(static_cast<Index>(tree_->subtrees.size()), 1, true,
                  [&](Index t, Index) { take(tree_->subtrees[static_cast<std::size_t>(t)]); });
    take(tree_->top);
    return positive;
  }

 private:
  using Matrix = Eigen::Matrix<Entry, Eigen::Dynamic, Eigen::Dynamic>;
  using Block = Eigen::Map<Matrix, 0, Eigen::OuterStride<>>;

  // Of a thread.
  struct Scratch {
    std::vector<int> slots;  // of each row of a front
    Matrix columns;          // of a front, where they are not kept
  };

  // Whether all pivots of a front are positive.
  bool eliminate(int number, Scratch& scratch) {
    const auto f = static_cast<std::size_t>(number);
    const Front& front = tree_->fronts[f];
    const Index w = front.columns, m = static_cast<Index>(front.rows.size());
    if (!factor_) scratch.columns.resize(w + m, w);
    Entry* const columns =
        factor_ ? factor_->entries.data() + factor_->start[f] : scratch.columns.data();
    updates_[f].resize(m, m);
    assemble(f, columns, updates_[f].data(), scratch.slots);
    return eliminate_columns(w, m, columns, updates_[f]);
  }

  // The matrix in the columns of a front and what its children leave. `slots`: of each of its rows.
  void assemble(std::size_t f, Entry* columns, Entry* update, std::vector<int>& slots) {
    const Front& front = tree_->fronts[f];
    const Index w = front.columns, m = static_cast<Index>(front.rows.size()), height = w + m;
    for (Index c = 0; c < w; ++c) {
      slots[static_cast<std::size_t>(front.first_column + c)] = static_cast<int>(c);
    }
    for (Index r = 0; r < m; ++r) {
      const int row = front.rows[static_cast<std::size_t>(r)];
      slots[static_cast<std::size_t>(row)] = static_cast<int>(w + r);
    }
    std::fill_n(columns, w * height, Entry(0));
    for (Index c = 0; c < m; ++c) std::fill_n(update + c * m + c, m - c, Entry(0));
    for (Index c = 0; c < w; ++c) {
      const auto column = static_cast<std::size_t>(front.first_column + c);
      for (int k = lower_->start[column]; k < lower_->start[column + 1]; ++k) {
        const auto entry = static_cast<std::size_t>(k);
        const int slot = slots[static_cast<std::size_t>(lower_->row[entry])];
        columns[c * height + slot] = lower_->value[entry];
      }
    }
    for (const int child : tree_->children[f]) {
      take_in(static_cast<std::size_t>(child), slots, w, m, columns, update);
    }
  }

  // Of a front with w columns and m rows below them; `update` becomes what is left for its parent.
  static bool eliminate_columns(Index w, Index m, Entry* columns, Matrix& update) {
    const Index height = w + m;
    for (Index k = 0; k < w; k += block_columns) {
      const Index b = std::min(block_columns, w - k), rest = height - k - b;
      const Eigen::OuterStride<> stride(height);
      Block diagonal(columns + k * height + k, b, b, stride);
      const Eigen::LLT<Eigen::Ref<Matrix, 0, Eigen::OuterStride<>>> in_place(diagonal);
      if (in_place.info() != Eigen::Success) return false;
      if (rest == 0) continue;
      Block below(columns + k * height + k + b, rest, b, stride);
      const auto transposed = diagonal.template triangularView<Eigen::Lower>().transpose();
      for_each_tile(rest, tile, rest > 2 * tile, [&](Index start, Index end) {
        auto rows = below.middleRows(start, end - start);
        transposed.template solveInPlace<Eigen::OnTheRight>(rows);
      });
      for_each_tile(w - k - b, block_columns, rest > 2 * tile, [&](Index start, Index end) {
        const Index first = k + b + start;
        Block later(columns + first * height + first, rest - start, end - start, stride);
        later.noalias() -=
            below.bottomRows(rest - start) * below.middleRows(start, end - start).transpose();
      });
    }
    const Block below(columns + w, m, w, Eigen::OuterStride<>(height));
    for_each_tile(m, m > 4 * tile ? tile : tile / 2, m > 2 * tile, [&](Index start, Index end) {
      update.block(start, start, m - start, end - start).noalias() -=
          below.bottomRows(m - start) * below.middleRows(start, end - start).transpose();
    });
    return true;
  }

  void take_in(std::size_t child, const std::vector<int>& slots, Index w, Index m, Entry* columns,
               Entry* update) {
    const std::vector<int>& rows = tree_->fronts[child].rows;
    std::vector<int> slot_of(rows.size());
    std::transform(rows.begin(), rows.end(), slot_of.begin(),
                   [&](int row) { return slots[static_cast<std::size_t>(row)]; });
    const auto size = static_cast<Index>(rows.size());
    const Entry* const from = updates_[child].data();
    const int* const slot = slot_of.data();
    for_each_tile(size, tile, size > 2 * tile, [&](Index start, Index end) {
      for (Index c = start; c < end; ++c) {
        const Index s = slot[c];
        Entry* const to = s < w ? columns + s * (w + m) : update + (s - w) * m - w;
        for (Index r = c; r < size; ++r) to[slot[r]] += from[c * size + r];
      }
    });
    updates_[child].resize(0, 0);
  }

  const EliminationTree* tree_;
  const OrderedLower<Entry>* lower_;
  FrontColumns<Entry>* factor_;
  std::vector<Matrix> updates_;  // of each front, lower triangles
};

}  // namespace

template <class Entry>
std::optional<FrontColumns<Entry>> factored(const EliminationTree& tree,
                                            const Eigen::SparseMatrix<double>& lower) {
  FrontColumns<Entry> factor;
  Index size = 0;
  for (const Front& front : tree.fronts) {
    factor.start.push_back(size);
    size += front.columns * (front.columns + static_cast<Index>(front.rows.size()));
  }
  factor.entries.resize(size);
  const OrderedLower<Entry> ordered = in_order<Entry>(lower, tree.order);
  if (!Elimination<Entry>(tree, ordered, &factor).run()) return std::nullopt;
  return factor;
}

template <class Entry>
bool has_positive_pivots(const EliminationTree& tree, const Eigen::SparseMatrix<double>& lower) {
  const OrderedLower<Entry> ordered = in_order<Entry>(lower, tree.order);
  return Elimination<Entry>(tree, ordered, nullptr).run();
}

template std::optional<FrontColumns<float>> factored(const EliminationTree&,
                                                     const Eigen::SparseMatrix<double>&);
template std::optional<FrontColumns<double>> factored(const EliminationTree&,
                                                      const Eigen::SparseMatrix<double>&);
template bool has_positive_pivots<float>(const EliminationTree&,
                                         const Eigen::SparseMatrix<double>&);
template bool has_positive_pivots<double>(const EliminationTree&,
                                          const Eigen::SparseMatrix<double>&);

}  // namespace wirepack
