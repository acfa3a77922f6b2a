#include "wirepack/solve/preconditioner.hpp"

#include <utility>
#include <variant>
#include <vector>

#include "triangular_factor.hpp"

namespace wirepack {

namespace {

// Rounding moves the rows of a model by its part of their diagonals: good enough where that is not
// far above the smallest eigenvalue, the shift. A few stiff rows, those of a short inlet edge, only
// move themselves.
bool single_precision_serves(const Eigen::SparseMatrix<double>& lower, double smallest) {
  const double rounding = 6e-8;
  return rounding * lower.diagonal().mean() < 10 * smallest;
}

}  // namespace

bool is_positive_definite(const Eigen::SparseMatrix<double>& lower, double smallest,
                          const std::vector<int>& order) {
  const EliminationTree tree = elimination_tree(lower, order);
  return single_precision_serves(lower, smallest) ? has_positive_pivots<float>(tree, lower)
                                                  : has_positive_pivots<double>(tree, lower);
}

struct Preconditioner::Factor {
  std::vector<int> order;  // place in the elimination -> unknown
  std::variant<TriangularFactor<float>, TriangularFactor<double>> triangle;
  double size;
  Eigen::VectorXd work;
};

Preconditioner::Preconditioner(std::unique_ptr<Factor> factor) : factor_(std::move(factor)) {}

std::optional<Preconditioner> Preconditioner::factored(const Eigen::SparseMatrix<double>& lower,
                                                       double smallest, Definiteness definiteness,
                                                       const std::vector<int>& order) {
  EliminationTree tree = elimination_tree(lower, order);
  double size = 0;
  for (const Front& front : tree.fronts) {
    const auto columns = static_cast<double>(front.columns);
    size += columns * ((columns + 1) / 2 + static_cast<double>(front.rows.size()));
  }
  const auto in = [&]<class Entry>(Entry) -> std::optional<Preconditioner> {
    std::optional<FrontColumns<Entry>> columns = wirepack::factored<Entry>(tree, lower);
    if (!columns) return std::nullopt;
    std::vector<int> own_order = tree.order;
    TriangularFactor<Entry> triangle(std::move(tree), std::move(*columns));
    return Preconditioner(std::make_unique<Factor>(
        Factor{std::move(own_order), std::move(triangle), size, Eigen::VectorXd(lower.rows())}));
  };
  if (single_precision_serves(lower, smallest)) {
    auto result = in(float{});
    if (result || definiteness == Definiteness::unknown) return result;
  }
  return in(double{});
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

const std::vector<int>& Preconditioner::order() const { return factor_->order; }

}  // namespace wirepack
