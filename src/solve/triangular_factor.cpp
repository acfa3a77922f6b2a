#include "triangular_factor.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace wirepack {

namespace {

// below += block x, for K columns of a block at a time: what each pass over `below` costs is shared.
template <int K, class Entry>
[[gnu::always_inline]] inline void add_columns(const Entry* block, Index rows, const double* x,
                                               double* below) {
#pragma omp simd
  for (Index r = 0; r < rows; ++r) {
    double sum = below[r];
    for (int c = 0; c < K; ++c) sum += static_cast<double>(block[c * rows + r]) * x[c];
    below[r] = sum;
  }
}

// x -= block^T below.
template <int K, class Entry>
[[gnu::always_inline]] inline void subtract_products(const Entry* block, Index rows,
                                                     const double* below, double* x) {
  double s0 = 0, s1 = 0, s2 = 0, s3 = 0;
#pragma omp simd reduction(+ : s0, s1, s2, s3)
  for (Index r = 0; r < rows; ++r) {
    const double b = below[r];
    s0 += static_cast<double>(block[r]) * b;
    if constexpr (K > 1) s1 += static_cast<double>(block[rows + r]) * b;
    if constexpr (K > 2) s2 += static_cast<double>(block[2 * rows + r]) * b;
    if constexpr (K > 3) s3 += static_cast<double>(block[3 * rows + r]) * b;
  }
  x[0] -= s0;
  if constexpr (K > 1) x[1] -= s1;
  if constexpr (K > 2) x[2] -= s2;
  if constexpr (K > 3) x[3] -= s3;
}

// A triangle is solved number after number; a narrow one leaves the work to the columns below it.
constexpr Index widest = 8;

// Calls f.template operator()<K>(c) for columns c, K of them at a time.
template <class F>
[[gnu::always_inline]] inline void by_four(Index columns, F&& f) {
  Index c = 0;
  for (; c + 4 <= columns; c += 4) f.template operator()<4>(c);
  if (columns - c == 3) f.template operator()<3>(c);
  if (columns - c == 2) f.template operator()<2>(c);
  if (columns - c == 1) f.template operator()<1>(c);
}

}  // namespace

template <class Entry>
TriangularFactor<Entry>::TriangularFactor(const cholmod_factor& factor) {
  assert(factor.is_super && factor.is_ll && factor.itype == CHOLMOD_INT);
  const auto* super = static_cast<const int*>(factor.super);
  const auto* row_start = static_cast<const int*>(factor.pi);
  const auto* value_start = static_cast<const int*>(factor.px);
  const auto* row = static_cast<const int*>(factor.s);
  const auto* value = static_cast<const double*>(factor.x);
  inverse_diagonal_.resize(static_cast<Index>(factor.n));
  panels_.reserve(factor.nsuper);
  Index most_rows = 0;
  for (std::size_t k = 0; k < factor.nsuper; ++k) {
    const Index columns = super[k + 1] - super[k];
    const Index rows = row_start[k + 1] - row_start[k];
    for (Index start = 0; start < columns; start += widest) {
      const Index width = std::min(widest, columns - start);
      const Index end = start + width;
      panels_.push_back(
          {super[k] + start, width, rows - end, triangle_.size(), below_.size(), rows_.size()});
      most_rows = std::max(most_rows, rows - end);
      for (Index c = start; c < end; ++c) {
        const double* const column = value + value_start[k] + c * rows;
        inverse_diagonal_[super[k] + c] = 1 / column[c];
        const auto as_entry = [](double v) { return static_cast<Entry>(v); };
        std::transform(column + c + 1, column + end, std::back_inserter(triangle_), as_entry);
        std::transform(column + end, column + rows, std::back_inserter(below_), as_entry);
      }
      // in a supernode the rows of its own columns come first
      rows_.insert(rows_.end(), row + row_start[k] + end, row + row_start[k + 1]);
    }
  }
  work_.resize(static_cast<std::size_t>(most_rows));
}

template <class Entry>
void TriangularFactor<Entry>::solve(Eigen::VectorXd& v) {
  double* const below = work_.data();
  for (const Panel& panel : panels_) {
    double* const x = v.data() + panel.first_column;
    const double* const inverse = inverse_diagonal_.data() + panel.first_column;
    const Entry* entry = triangle_.data() + panel.triangle;
    for (Index c = 0; c < panel.columns; ++c) {
      x[c] *= inverse[c];
      for (Index r = c + 1; r < panel.columns; ++r) x[r] -= static_cast<double>(*entry++) * x[c];
    }
    const Index rows = panel.rows_below;
    if (rows == 0) continue;
    const Entry* const block = below_.data() + panel.below;
    std::fill_n(below, rows, 0.0);
    by_four(panel.columns,
            [&]<int K>(Index c) { add_columns<K>(block + c * rows, rows, x + c, below); });
    const int* const row = rows_.data() + panel.row_list;
    for (Index r = 0; r < rows; ++r) v[row[r]] -= below[r];
  }
}

template <class Entry>
void TriangularFactor<Entry>::solve_transposed(Eigen::VectorXd& v) {
  double* const below = work_.data();
  for (auto panel = panels_.rbegin(); panel != panels_.rend(); ++panel) {
    double* const x = v.data() + panel->first_column;
    const Index rows = panel->rows_below, columns = panel->columns;
    if (rows > 0) {
      const int* const row = rows_.data() + panel->row_list;
      for (Index r = 0; r < rows; ++r) below[r] = v[row[r]];
      const Entry* const block = below_.data() + panel->below;
      by_four(columns,
              [&]<int K>(Index c) { subtract_products<K>(block + c * rows, rows, below, x + c); });
    }
    // columns backwards: the entries of column c end where those of c + 1 start
    const double* const inverse = inverse_diagonal_.data() + panel->first_column;
    const Entry* entry = triangle_.data() + panel->triangle + columns * (columns - 1) / 2;
    for (Index c = columns; c-- > 0;) {
      entry -= columns - 1 - c;
      double sum = x[c];
      for (Index r = c + 1; r < columns; ++r) sum -= static_cast<double>(entry[r - c - 1]) * x[r];
      x[c] = sum * inverse[c];
    }
  }
}

template class TriangularFactor<float>;
template class TriangularFactor<double>;

}  // namespace wirepack
