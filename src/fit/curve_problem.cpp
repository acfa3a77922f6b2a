#include "curve_problem.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <ceres/ceres.h>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace wirepack {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Residuals and their derivatives of all points for the curve that Ceres is at.
class Residuals : public ceres::EvaluationCallback {
 public:
  Residuals(const MeasuredPoints& points, const FitStart& start)
      : points_(points),
        curve_(start.basis, start.pose),
        feet_(start.feet),
        rows_(points.arc.size() > 0 ? 3 : 2),
        values_(3, points.count()) {
    unknowns_ = Eigen::VectorXd::Zero(curve_.size());
    unknowns_.tail(start.shape_unknowns.size()) = start.shape_unknowns;
  }

  Eigen::VectorXd& unknowns() { return unknowns_; }
  double squares() const { return values_.topRows(rows_).squaredNorm(); }
  Index rows() const { return rows_; }
  double value(Index point, Index row) const { return values_(row, point); }
  const Points& values() const { return values_; }
  const RowMajor& jacobian() const { return jacobian_; }
  const DarbouxCurve& curve() const { return curve_; }
  const Eigen::VectorXd& feet() const { return feet_; }
  Eigen::VectorXd weighted_distances() const {
    return values_.topRows(rows_).colwise().norm().transpose();
  }
  double weight(Index point) const {
    return points_.sigma.size() > 0 ? 1 / points_.sigma[point] : 1;
  }

  void PrepareForEvaluation(bool with_derivatives, bool new_point) override {
    if (!new_point && !with_derivatives) return;
    curve_.set_unknowns(unknowns_, with_derivatives);
    if (with_derivatives) jacobian_.resize(rows_ * points_.count(), curve_.size());
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> by_unknowns(3, curve_.size());
    for (Index i = 0; i < points_.count(); ++i) {
      const Vec3 point = points_.position.col(i);
      if (new_point && rows_ == 2) feet_[i] = curve_.foot(point, feet_[i]);
      const DarbouxCurve::Pose foot = curve_.at(feet_[i]);
      values_.col(i) = weight(i) * (foot.directors.transpose() * (point - foot.position));
      if (!with_derivatives) continue;
      curve_.by_unknowns(feet_[i], foot, foot.directors, by_unknowns);
      jacobian_.middleRows(rows_ * i, rows_) = -weight(i) * by_unknowns.topRows(rows_);
    }
  }

 private:
  const MeasuredPoints& points_;
  DarbouxCurve curve_;
  Eigen::VectorXd unknowns_, feet_;
  Index rows_;
  Points values_;
  RowMajor jacobian_;
};

/// What Residuals has prepared for one point.
class PointCost : public ceres::CostFunction {
 public:
  PointCost(const Residuals& residuals, Index point) : residuals_(residuals), point_(point) {
    set_num_residuals(static_cast<int>(residuals.rows()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(residuals.curve().size()));
  }
  bool Evaluate(double const* const*, double* values, double** jacobians) const override {
    const Index rows = residuals_.rows(), size = residuals_.curve().size();
    // a step that overflows is no step: Ceres takes a shorter one
    if (!residuals_.values().col(point_).allFinite()) return false;
    for (Index r = 0; r < rows; ++r) values[r] = residuals_.value(point_, r);
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      Eigen::Map<RowMajor>(jacobians[0], rows, size) =
          residuals_.jacobian().middleRows(rows * point_, rows);
    }
    return true;
  }

 private:
  const Residuals& residuals_;
  Index point_;
};

// No direction of the unknowns lets the residuals fall noticeably: each column of the Jacobian is
// normal to them, or they, or what it could take from them, are nothing but round-off.
bool is_solved(const Residuals& residuals, const RowMajor& jacobian, double huber) {
  const Eigen::VectorXd distances = residuals.weighted_distances();
  Eigen::VectorXd bounded(jacobian.rows());
  double unweighted = 0, largest_weight = 0;
  for (Index i = 0; i < distances.size(); ++i) {
    const double share = huber > 0 && distances[i] > huber ? huber / distances[i] : 1;
    for (Index r = 0; r < residuals.rows(); ++r) {
      bounded[residuals.rows() * i + r] = share * residuals.value(i, r);
    }
    unweighted = std::max(unweighted, distances[i] / residuals.weight(i));
    largest_weight = std::max(largest_weight, residuals.weight(i));
  }
  if (unweighted < 1e-11) return true;
  const double noticeable = std::max(1e-5 * bounded.norm(), 1e-12 * largest_weight);
  for (Index k = 0; k < jacobian.cols(); ++k) {
    if (k == DarbouxCurve::shift_along && residuals.rows() == 2) continue;
    if (std::abs(jacobian.col(k).dot(bounded)) > noticeable * jacobian.col(k).norm()) return false;
  }
  return true;
}

// Steps of Gauss and Newton to where round-off ends them, so that the shape does not depend on when
// a minimizer stops. A step that does not lead down is taken back.
void polish(Residuals& residuals) {
  std::vector<Index> free;
  for (Index k = 0; k < residuals.unknowns().size(); ++k) {
    if (k != DarbouxCurve::shift_along || residuals.rows() == 3) free.push_back(k);
  }
  const Index rows = residuals.rows();
  double last = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 40; ++round) {
    const Eigen::VectorXd before = residuals.unknowns();
    const double squares = residuals.squares();
    const Eigen::MatrixXd jacobian = residuals.jacobian()(Eigen::all, free);
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(jacobian);
    qr.setThreshold(1e-9);
    const Points values = residuals.values();
    const Eigen::VectorXd step = qr.solve(values.topRows(rows).reshaped());
    residuals.unknowns()(free) -= step;
    residuals.PrepareForEvaluation(true, true);
    if (!(residuals.squares() <= squares * (1 + 1e-11))) {
      residuals.unknowns() = before;
      residuals.PrepareForEvaluation(true, true);
      return;
    }
    const double size = step.norm() / before.norm();
    if (size <= 1e-15 || (size < 1e-11 && size > 0.7 * last)) return;
    last = size;
  }
}

}  // namespace

CurveSolution solve_curve(const MeasuredPoints& points, const FitStart& start, double huber,
                          int most_iterations) {
  Residuals residuals(points, start);
  Eigen::VectorXd& unknowns = residuals.unknowns();
  ceres::Problem::Options problem_options;
  problem_options.evaluation_callback = &residuals;
  ceres::Problem problem(problem_options);
  problem.AddParameterBlock(unknowns.data(), static_cast<int>(unknowns.size()));
  if (residuals.rows() == 2) {
    problem.SetManifold(
        unknowns.data(),
        new ceres::SubsetManifold(static_cast<int>(unknowns.size()), {DarbouxCurve::shift_along}));
  }
  for (Index i = 0; i < points.count(); ++i) {
    problem.AddResidualBlock(new PointCost(residuals, i),
                             huber > 0 ? new ceres::HuberLoss(huber) : nullptr, unknowns.data());
  }
  ceres::Solver::Options options;
  options.max_num_iterations = most_iterations;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.function_tolerance = 1e-16;
  options.gradient_tolerance = 1e-16;
  options.parameter_tolerance = 1e-13;
  // QR keeps the digits, the normal equations are quick
  options.linear_solver_type =
      points.count() * unknowns.size() < 10000 ? ceres::DENSE_QR : ceres::DENSE_NORMAL_CHOLESKY;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);

  residuals.PrepareForEvaluation(true, true);
  const bool to_the_end = summary.termination_type == ceres::CONVERGENCE;
  if (to_the_end && huber == 0) polish(residuals);
  CurveSolution solution{residuals.curve(), residuals.feet(), {}, {}, {}, {}, {}, {}, {}, {}};
  solution.rows = residuals.rows();
  solution.huber = huber;
  solution.cost = huber > 0 ? summary.final_cost : residuals.squares() / 2;
  solution.jacobian = residuals.jacobian();
  solution.weighted_distance = residuals.weighted_distances();
  solution.distance.resize(points.count());
  solution.residual.resize(3, points.count());
  for (Index i = 0; i < points.count(); ++i) {
    solution.distance[i] = solution.weighted_distance[i] / residuals.weight(i);
    Vec3 value = residuals.values().col(i);
    if (solution.rows == 2) value.z() = 0;
    solution.residual.col(i) = residuals.curve().at(residuals.feet()[i]).directors * value;
  }
  const bool finite = solution.jacobian.allFinite() && solution.weighted_distance.allFinite();
  if (!finite) solution.cost = std::numeric_limits<double>::infinity();
  solution.converged = finite && is_solved(residuals, residuals.jacobian(), huber);
  return solution;
}

FitStart continued(const CurveSolution& solution) {
  const DarbouxBasis& basis = solution.curve.basis();
  return {basis, solution.curve.at(basis.middle()), solution.curve.unknowns().tail(basis.size()),
          solution.feet};
}

}  // namespace wirepack
