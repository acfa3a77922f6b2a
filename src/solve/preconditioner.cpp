#include "wirepack/solve/preconditioner.hpp"

#include <algorithm>
#include <cholmod.h>
#include <numeric>
#include <omp.h>
#include <variant>
#include <vector>

#include "wirepack/core/error.hpp"

#include "triangular_factor.hpp"

namespace wirepack {

namespace {

// CHOLMOD starts threads of its own for every factor, however small; on fronts of this size they
// cost more than they bring (2.4 against 0.9 ms at N = 280, two cores).
class OneThread {
 public:
  OneThread() : levels_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
  ~OneThread() { omp_set_max_active_levels(levels_); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int levels_;
};

// Owns what CHOLMOD needs while it factors.
struct Cholmod {
  cholmod_common common;
  cholmod_factor* factor = nullptr;

  Cholmod() {
    cholmod_start(&common);
    common.final_ll = 1;
    common.print = 0;  // failures are reported by exceptions
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_NATURAL;  // the matrix comes in the order of elimination
    common.postorder = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
  }
  ~Cholmod() {
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;
};

// View of a lower triangle; without values where `values` is null.
cholmod_sparse lower_view(Index size, const std::vector<int>& starts, const std::vector<int>& rows,
                          const double* values) {
  cholmod_sparse a{};
  a.nrow = a.ncol = static_cast<std::size_t>(size);
  a.nzmax = rows.size();
  a.p = const_cast<int*>(starts.data());
  a.i = const_cast<int*>(rows.data());
  a.x = const_cast<double*>(values);
  a.stype = -1;
  a.itype = CHOLMOD_INT;
  a.xtype = values != nullptr ? CHOLMOD_REAL : CHOLMOD_PATTERN;
  a.dtype = CHOLMOD_DOUBLE;
  a.packed = 1;
  return a;
}

// Unknowns in the order of elimination. The unknowns of a node are coupled to the same others, so
// neighbouring columns of one pattern are ordered as one by AMD: a tenth of the work.
std::vector<int> elimination_order(const Eigen::SparseMatrix<double>& lower, Cholmod& cholmod) {
  const auto n = static_cast<int>(lower.cols());
  const int* const start = lower.outerIndexPtr();
  const int* const row = lower.innerIndexPtr();
  std::vector<int> group_of(static_cast<std::size_t>(n)), first;  // of each group, its first column
  for (int c = 0; c < n; ++c) {
    const bool joins = c > 0 && start[c + 1] - start[c] == start[c] - start[c - 1] - 1 &&
                       std::equal(row + start[c], row + start[c + 1], row + start[c - 1] + 1);
    if (!joins) first.push_back(c);
    group_of[static_cast<std::size_t>(c)] = static_cast<int>(first.size()) - 1;
  }
  const auto groups = static_cast<Index>(first.size());
  first.push_back(n);
  std::vector<int> starts{0}, rows;
  for (Index g = 0; g < groups; ++g) {
    const int c = first[static_cast<std::size_t>(g)];
    int last = -1;
    for (int k = start[c]; k < start[c + 1]; ++k) {
      const int other = group_of[static_cast<std::size_t>(row[k])];
      if (other != last) rows.push_back(last = other);
    }
    starts.push_back(static_cast<int>(rows.size()));
  }
  cholmod_sparse pattern = lower_view(groups, starts, rows, nullptr);
  pattern.sorted = 1;
  std::vector<int> group_order(static_cast<std::size_t>(groups));
  if (cholmod_amd(&pattern, nullptr, 0, group_order.data(), &cholmod.common) == 0) {
    throw NumericalFailure("the curvature model cannot be ordered");
  }
  std::vector<int> order;
  order.reserve(static_cast<std::size_t>(n));
  for (const int g : group_order) {
    const auto k = static_cast<std::size_t>(g);
    for (int c = first[k]; c < first[k + 1]; ++c) order.push_back(c);
  }
  return order;
}

struct LowerTriangle {
  std::vector<int> starts, rows;
  std::vector<double> values;
};

// The lower triangle of the matrix whose unknown k is order[k]; rows of a column are not sorted.
LowerTriangle reordered(const Eigen::SparseMatrix<double>& lower, const std::vector<int>& order) {
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
  LowerTriangle result;
  result.starts.assign(order.size() + 1, 0);
  for_each_entry([&](int c, int, double) { ++result.starts[static_cast<std::size_t>(c) + 1]; });
  std::partial_sum(result.starts.begin(), result.starts.end(), result.starts.begin());
  std::vector<int> next(result.starts.begin(), result.starts.end() - 1);
  result.rows.resize(static_cast<std::size_t>(lower.nonZeros()));
  result.values.resize(result.rows.size());
  for_each_entry([&](int c, int r, double value) {
    const auto k = static_cast<std::size_t>(next[static_cast<std::size_t>(c)]++);
    result.rows[k] = r;
    result.values[k] = value;
  });
  return result;
}

// Single precision moves eigenvalues of the model by its rounding times the largest of them: good
// enough where that is not far above the smallest, the shift.
bool single_precision_serves(const Eigen::SparseMatrix<double>& lower, double smallest) {
  const double rounding = 6e-8;
  return rounding * lower.diagonal().maxCoeff() < 10 * smallest;
}

}  // namespace

struct Preconditioner::Factor {
  std::vector<int> order;  // place in the factor -> unknown
  std::variant<TriangularFactor<float>, TriangularFactor<double>> triangle;
  double size;
  Eigen::VectorXd work;
};

Preconditioner::Preconditioner(std::unique_ptr<Factor> factor) : factor_(std::move(factor)) {}

std::optional<Preconditioner> Preconditioner::factored(const Eigen::SparseMatrix<double>& lower,
                                                       double smallest) {
  const OneThread one_thread;
  Cholmod cholmod;
  std::vector<int> order = elimination_order(lower, cholmod);
  const LowerTriangle ordered = reordered(lower, order);
  cholmod_sparse a = lower_view(lower.cols(), ordered.starts, ordered.rows, ordered.values.data());
  cholmod.factor = cholmod_analyze(&a, &cholmod.common);
  if (cholmod.factor == nullptr) throw NumericalFailure("the curvature model cannot be ordered");
  cholmod_factorize(&a, cholmod.factor, &cholmod.common);
  const cholmod_factor& factor = *cholmod.factor;
  if (cholmod.common.status < CHOLMOD_OK) {
    throw NumericalFailure("the curvature model cannot be factored");
  }
  if (factor.minor < factor.n) return std::nullopt;
  const auto triangle = [&]() -> decltype(Factor::triangle) {
    if (single_precision_serves(lower, smallest)) return TriangularFactor<float>(factor);
    return TriangularFactor<double>(factor);
  };
  return Preconditioner(std::make_unique<Factor>(Factor{std::move(order), triangle(),
                                                        static_cast<double>(factor.xsize),
                                                        Eigen::VectorXd(lower.rows())}));
}

Preconditioner::~Preconditioner() = default;
Preconditioner::Preconditioner(Preconditioner&&) noexcept = default;
Preconditioner& Preconditioner::operator=(Preconditioner&&) noexcept = default;

void Preconditioner::to_step(const Eigen::VectorXd& y, Eigen::VectorXd& step) {
  Factor& f = *factor_;
  f.work = y;
  std::visit([&](auto& triangle) { triangle.solve_transposed(f.work); }, f.triangle);
  step.resize(y.size());
  for (Index k = 0; k < y.size(); ++k) step[f.order[static_cast<std::size_t>(k)]] = f.work[k];
}

void Preconditioner::to_gradient(const Eigen::VectorXd& by_x, Eigen::VectorXd& by_y) {
  Factor& f = *factor_;
  by_y.resize(by_x.size());
  for (Index k = 0; k < by_x.size(); ++k) by_y[k] = by_x[f.order[static_cast<std::size_t>(k)]];
  std::visit([&](auto& triangle) { triangle.solve(by_y); }, f.triangle);
}

double Preconditioner::factor_size() const { return factor_->size; }

}  // namespace wirepack
