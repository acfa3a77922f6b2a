#include "wirepack/solve/preconditioner.hpp"

#include <cholmod.h>
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
    common.print = 0;     // failures are reported by exceptions
    common.nmethods = 1;  // one ordering, always the same: AMD
    common.method[0].ordering = CHOLMOD_AMD;
    common.postorder = 1;
    common.supernodal = CHOLMOD_SUPERNODAL;
  }
  ~Cholmod() {
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;
};

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

Preconditioner::Preconditioner(const Eigen::SparseMatrix<double>& lower, double smallest) {
  cholmod_sparse a{};
  a.nrow = a.ncol = static_cast<std::size_t>(lower.rows());
  a.nzmax = static_cast<std::size_t>(lower.nonZeros());
  a.p = const_cast<int*>(lower.outerIndexPtr());
  a.i = const_cast<int*>(lower.innerIndexPtr());
  a.x = const_cast<double*>(lower.valuePtr());
  a.stype = -1;
  a.itype = CHOLMOD_INT;
  a.xtype = CHOLMOD_REAL;
  a.dtype = CHOLMOD_DOUBLE;
  a.sorted = 1;
  a.packed = 1;
  const OneThread one_thread;
  Cholmod cholmod;
  cholmod.factor = cholmod_analyze(&a, &cholmod.common);
  if (cholmod.factor == nullptr) throw NumericalFailure("the curvature model cannot be ordered");
  cholmod_factorize(&a, cholmod.factor, &cholmod.common);
  const cholmod_factor& factor = *cholmod.factor;
  if (cholmod.common.status != CHOLMOD_OK || factor.minor < factor.n) {
    throw NumericalFailure("the curvature model is not positive definite");
  }
  const auto* order = static_cast<const int*>(factor.Perm);
  const auto triangle = [&]() -> decltype(Factor::triangle) {
    if (single_precision_serves(lower, smallest)) return TriangularFactor<float>(factor);
    return TriangularFactor<double>(factor);
  };
  factor_ = std::make_unique<Factor>(Factor{{order, order + factor.n},
                                            triangle(),
                                            static_cast<double>(factor.xsize),
                                            Eigen::VectorXd(lower.rows())});
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
