#include "triangular_factor.hpp"

#include <algorithm>
#include <type_traits>

#include "wirepack/core/lanes.hpp"
#include "wirepack/core/threads.hpp"

namespace wirepack {

namespace {

// below -= block x, for K columns of a block at a time: what each pass over `below` costs is
// shared.
template <int K, class Entry>
[[gnu::always_inline]] inline void subtract_columns(const Entry* block, Index stride, Index rows,
                                                    const double* x, double* below) {
#pragma omp simd
  for (Index r = 0; r < rows; ++r) {
    double sum = 0;
    for (int c = 0; c < K; ++c) sum += static_cast<double>(block[c * stride + r]) * x[c];
    below[r] -= sum;
  }
}

// x -= block^T below.
template <int K, class Entry>
[[gnu::always_inline]] inline void subtract_products(const Entry* block, Index stride, Index rows,
                                                     const double* below, double* x) {
  LaneSum sums[K];
  for_each_in_lanes(0, rows, [&]<class T>(Index r) {
    const T b = load<T>(below + r);
    for (int c = 0; c < K; ++c) {
      const Entry* const entry = block + c * stride + r;
      if constexpr (std::is_same_v<T, Lanes>) {
        sums[c].add(lanes_of([&](int k) { return entry[k]; }) * b);
      } else {
        sums[c].add(static_cast<double>(*entry) * b);
      }
    }
  });
  for (int c = 0; c < K; ++c) x[c] -= sums[c].total();
}

// A triangle is solved number after number; a narrow one leaves the work to the rows below it.
constexpr Index panel_columns = 8;
// What a thread takes of the rows below a front, or of its columns; a front is shared out from so
// many entries on.
constexpr Index row_tile = 256, column_tile = 16, shared_entries = 20000;

// Calls f.template operator()<K>(c) for columns c of `start` to `end`, K of them at a time.
template <class F>
[[gnu::always_inline]] inline void by_four(Index start, Index end, F&& f) {
  Index c = start;
  for (; c + 4 <= end; c += 4) f.template operator()<4>(c);
  if (end - c == 3) f.template operator()<3>(c);
  if (end - c == 2) f.template operator()<2>(c);
  if (end - c == 1) f.template operator()<1>(c);
}

}  // namespace

template <class Entry>
TriangularFactor<Entry>::TriangularFactor(EliminationTree tree, FrontColumns<Entry> factor)
    : fronts_(std::move(tree.fronts)), factor_(std::move(factor)) {
  const auto unknowns = static_cast<Index>(tree.order.size());
  inverse_diagonal_.resize(unknowns);
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    const Front& front = fronts_[f];
    const Index height = front.columns + static_cast<Index>(front.rows.size());
    for (Index c = 0; c < front.columns; ++c) {
      const Entry* const diagonal = factor_.entries.data() + factor_.start[f] + c * (height + 1);
      inverse_diagonal_[front.first_column + c] = 1 / static_cast<double>(*diagonal);
    }
  }
  const auto set_work = [&](Part& part) {
    std::size_t most = 0;
    for (const int f : part.fronts) {
      most = std::max(most, fronts_[static_cast<std::size_t>(f)].rows.size());
    }
    part.work.resize(static_cast<Index>(most));
  };
  top_.fronts = std::move(tree.top);
  set_work(top_);
  Index copies = unknowns;
  for (std::vector<int>& fronts : tree.subtrees) {
    // every row of a subtree that lies outside is one of its root's
    const Front& root = fronts_[static_cast<std::size_t>(fronts.back())];
    Part part{std::move(fronts), root.rows, copies, {}};
    set_work(part);
    const Index inside = root.first_column + root.columns;
    for (const int f : part.fronts) {
      auto next = part.rows_outside.begin();
      for (int& row : fronts_[static_cast<std::size_t>(f)].rows) {
        if (row < inside) continue;
        next = std::lower_bound(next, part.rows_outside.end(), row);
        row = static_cast<int>(copies + (next - part.rows_outside.begin()));
      }
    }
    copies += static_cast<Index>(part.rows_outside.size());
    subtrees_.push_back(std::move(part));
  }
  values_.resize(copies);
}

template <class Entry>
void TriangularFactor<Entry>::solve(Eigen::VectorXd& v) {
  values_.head(v.size()) = v;
  values_.tail(values_.size() - v.size()).setZero();
  for_each_tile(static_cast<Index>(subtrees_.size()), 1, is_large(),
                [&](Index t, Index) { forward(subtrees_[static_cast<std::size_t>(t)]); });
  for (const Part& part : subtrees_) {
    const double* copy = values_.data() + part.copy;
    for (const int row : part.rows_outside) values_[row] += *copy++;
  }
  forward(top_);
  v = values_.head(v.size());
}

template <class Entry>
void TriangularFactor<Entry>::solve_transposed(Eigen::VectorXd& v) {
  values_.head(v.size()) = v;
  backward(top_);
  for (const Part& part : subtrees_) {
    double* copy = values_.data() + part.copy;
    for (const int row : part.rows_outside) *copy++ = values_[row];
  }
  for_each_tile(static_cast<Index>(subtrees_.size()), 1, is_large(),
                [&](Index t, Index) { backward(subtrees_[static_cast<std::size_t>(t)]); });
  v = values_.head(v.size());
}

// Whether there is enough to do for more than one thread.
template <class Entry>
bool TriangularFactor<Entry>::is_large() const {
  return factor_.entries.size() > 10 * shared_entries;
}

template <class Entry>
auto TriangularFactor<Entry>::columns_of(int number, const Part& part) -> Columns {
  const auto f = static_cast<std::size_t>(number);
  const Front& front = fronts_[f];
  const Index w = front.columns, m = static_cast<Index>(front.rows.size());
  return {w,
          m,
          w + m,
          factor_.entries.data() + factor_.start[f],
          values_.data() + front.first_column,
          inverse_diagonal_.data() + front.first_column,
          front.rows.data(),
          &part == &top_ && m * w > shared_entries};
}

template <class Entry>
void TriangularFactor<Entry>::forward(Part& part) {
  for (const int number : part.fronts) {
    const Columns front = columns_of(number, part);
    const Index w = front.w, m = front.m, height = front.height;
    const Entry* const columns = front.entry;
    double* const x = front.x;
    for (Index start = 0; start < w; start += panel_columns) {
      const Index end = std::min(start + panel_columns, w);
      for (Index c = start; c < end; ++c) {
        x[c] *= front.inverse[c];
        for (Index r = c + 1; r < end; ++r) {
          x[r] -= static_cast<double>(columns[c * height + r]) * x[c];
        }
      }
      by_four(start, end, [&]<int K>(Index c) {
        subtract_columns<K>(columns + c * height + end, height, w - end, x + c, x + end);
      });
    }
    double* const below = part.work.data();
    std::fill_n(below, m, 0.0);
    for_each_tile(m, row_tile, front.shared, [&](Index start, Index end) {
      by_four(0, w, [&]<int K>(Index c) {
        const Entry* const block = columns + c * height + w + start;
        subtract_columns<K>(block, height, end - start, x + c, below + start);
      });
    });
    for (Index r = 0; r < m; ++r) values_[front.row[r]] += below[r];
  }
}

template <class Entry>
void TriangularFactor<Entry>::backward(Part& part) {
  for (auto number = part.fronts.rbegin(); number != part.fronts.rend(); ++number) {
    const Columns front = columns_of(*number, part);
    const Index w = front.w, m = front.m, height = front.height;
    const Entry* const columns = front.entry;
    double* const x = front.x;
    double* const below = part.work.data();
    for (Index r = 0; r < m; ++r) below[r] = values_[front.row[r]];
    for_each_tile(w, column_tile, front.shared, [&](Index first, Index last) {
      by_four(first, last, [&]<int K>(Index c) {
        subtract_products<K>(columns + c * height + w, height, m, below, x + c);
      });
    });
    const Index panels = (w + panel_columns - 1) / panel_columns;
    for (Index panel = panels; panel-- > 0;) {
      const Index start = panel * panel_columns, end = std::min(start + panel_columns, w);
      by_four(start, end, [&]<int K>(Index c) {
        subtract_products<K>(columns + c * height + end, height, w - end, x + end, x + c);
      });
      // a number that is known leaves all others at once: their sums do not wait for each other
      for (Index r = end; r-- > start;) {
        x[r] *= front.inverse[r];
        for (Index c = start; c < r; ++c) {
          x[c] -= static_cast<double>(columns[c * height + r]) * x[r];
        }
      }
    }
  }
}

template class TriangularFactor<float>;
template class TriangularFactor<double>;

}  // namespace wirepack
