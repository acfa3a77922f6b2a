#include "wirepack/solve/preconditioner.hpp"

#include <cholmod.h>
#include <omp.h>

#include "wirepack/core/error.hpp"

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

}  // namespace

struct Preconditioner::Factor {
  cholmod_common common;
  cholmod_factor* factor = nullptr;
  cholmod_dense* result = nullptr;
  cholmod_dense* middle = nullptr;
  cholmod_dense* work1 = nullptr;
  cholmod_dense* work2 = nullptr;

  Factor() {
    cholmod_start(&common);
    common.final_ll = 1;  // L L^T also where simplicial factors would be L D L^T
    common.print = 0;     // failures are reported by exceptions
    common.nmethods = 1;  // one ordering, always the same: AMD
    common.method[0].ordering = CHOLMOD_AMD;
    common.postorder = 1;
  }
  ~Factor() {
    cholmod_free_factor(&factor, &common);
    for (cholmod_dense** d : {&result, &middle, &work1, &work2}) cholmod_free_dense(d, &common);
    cholmod_finish(&common);
  }
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;

  void solve(int first, int second, const Eigen::VectorXd& in, Eigen::VectorXd& out) {
    cholmod_dense b{};
    b.nrow = b.nzmax = b.d = static_cast<std::size_t>(in.size());
    b.ncol = 1;
    b.x = const_cast<double*>(in.data());  // CHOLMOD reads right-hand sides, but takes no const
    b.xtype = CHOLMOD_REAL;
    b.dtype = CHOLMOD_DOUBLE;
    const bool ok =
        cholmod_solve2(first, factor, &b, nullptr, &middle, nullptr, &work1, &work2, &common) &&
        cholmod_solve2(second, factor, middle, nullptr, &result, nullptr, &work1, &work2, &common);
    if (!ok) throw NumericalFailure("a triangular solve failed");
    out = Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(result->x), in.size());
  }
};

Preconditioner::Preconditioner(const Eigen::SparseMatrix<double>& lower)
    : factor_(std::make_unique<Factor>()) {
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
  factor_->factor = cholmod_analyze(&a, &factor_->common);
  if (factor_->factor == nullptr) throw NumericalFailure("the curvature model cannot be ordered");
  cholmod_factorize(&a, factor_->factor, &factor_->common);
  if (factor_->common.status != CHOLMOD_OK || factor_->factor->minor < factor_->factor->n) {
    throw NumericalFailure("the curvature model is not positive definite");
  }
}

Preconditioner::~Preconditioner() = default;
Preconditioner::Preconditioner(Preconditioner&&) noexcept = default;
Preconditioner& Preconditioner::operator=(Preconditioner&&) noexcept = default;

void Preconditioner::to_step(const Eigen::VectorXd& y, Eigen::VectorXd& step) {
  factor_->solve(CHOLMOD_Lt, CHOLMOD_Pt, y, step);
}

void Preconditioner::to_gradient(const Eigen::VectorXd& by_x, Eigen::VectorXd& by_y) {
  factor_->solve(CHOLMOD_P, CHOLMOD_L, by_x, by_y);
}

double Preconditioner::factor_size() const {
  const cholmod_factor& f = *factor_->factor;
  return static_cast<double>(f.is_super ? f.xsize : f.nzmax);
}

}  // namespace wirepack
