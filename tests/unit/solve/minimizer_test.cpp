#include "wirepack/solve/minimizer.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <stdexcept>

#include "wirepack/core/threads.hpp"

namespace wirepack {
namespace {

class Descent : public testing::TestWithParam<DescentMethod> {
 protected:
  DescentOptions options(int max_evaluations = 50) const {
    return {max_evaluations, 20, GetParam()};
  }
};

INSTANTIATE_TEST_SUITE_P(Methods, Descent,
                         testing::Values(DescentMethod::nlopt_lbfgs, DescentMethod::compact_lbfgs),
                         [](const auto& method) {
                           return method.param == DescentMethod::nlopt_lbfgs ? "Nlopt" : "Compact";
                         });

TEST_P(Descent, ExceptionsOfTheObjectiveAreHandedOnAtOnce) {
  int calls = 0;
  const Objective objective = [&](const Eigen::VectorXd&, Eigen::VectorXd&) -> Evaluation {
    ++calls;
    throw std::runtime_error("no");
  };
  EXPECT_THROW(descend(objective, Eigen::VectorXd::Zero(3), options()), std::runtime_error);
  EXPECT_EQ(calls, 1);
}

TEST_P(Descent, FindsTheMinimumOfAQuadraticAndStopsWhereItIsTold) {
  const Eigen::Vector3d target(1, -2, 3);
  const Objective objective = [&](const Eigen::VectorXd& y, Eigen::VectorXd& gradient) {
    gradient = 2 * (y - target);
    return Evaluation{(y - target).squaredNorm(), (y - target).norm() < 1e-6};
  };
  const DescentReport report = descend(objective, Eigen::VectorXd::Zero(3), options());
  EXPECT_EQ(report.end, DescentEnd::good_enough);
  EXPECT_LT(report.evaluations, 10);
}

TEST_P(Descent, EvaluationsEndAtTheirLimit) {
  const Objective objective = [](const Eigen::VectorXd& y, Eigen::VectorXd& gradient) {
    gradient = y.cwiseProduct(y).cwiseProduct(y);
    return Evaluation{gradient.dot(y) / 4, false};
  };
  const DescentReport report = descend(objective, Eigen::VectorXd::LinSpaced(9, 1, 9), options(6));
  EXPECT_EQ(report.end, DescentEnd::evaluation_limit);
  EXPECT_LE(report.evaluations, 7);
}

// Rosenbrock's valley in pairs of unknowns.
Evaluation valley(const Eigen::VectorXd& y, Eigen::VectorXd& gradient) {
  gradient.resize(y.size());
  double value = 0;
  for (Index i = 0; i < y.size(); i += 2) {
    const double off = y[i + 1] - y[i] * y[i], left = 1 - y[i];
    value += 100 * off * off + left * left;
    gradient[i] = -400 * off * y[i] - 2 * left;
    gradient[i + 1] = 200 * off;
  }
  return {value, (y.array() - 1).abs().maxCoeff() < 1e-6};
}

Eigen::VectorXd valley_start(Index size) {
  Eigen::VectorXd y(size);
  for (Index i = 0; i < size; ++i)
    y[i] = (i % 2 == 0 ? -1.2 : 1) + 0.001 * static_cast<double>(i % 7);
  return y;
}

// Steepest descent takes some ten thousand; a wrong factor in the inverse Hessian, hundreds.
TEST_P(Descent, ACurvedValleyTakesFewEvaluations) {
  const DescentReport report = descend(valley, valley_start(40), options(1000));
  EXPECT_EQ(report.end, DescentEnd::good_enough);
  EXPECT_LT(report.evaluations, 120);
}

// With as many pairs as unknowns, L-BFGS on a quadratic function knows its Hessian.
TEST_P(Descent, PairsOfAllDirectionsMakeTheNextStepTheLast) {
  const Eigen::VectorXd curvature = Eigen::VectorXd::LinSpaced(12, 1, 200);
  const Objective objective = [&](const Eigen::VectorXd& y, Eigen::VectorXd& gradient) {
    gradient = curvature.cwiseProduct(y);
    return Evaluation{gradient.dot(y) / 2, y.norm() < 1e-9};
  };
  const DescentReport report = descend(objective, Eigen::VectorXd::Ones(12), options(200));
  EXPECT_EQ(report.end, DescentEnd::good_enough);
  EXPECT_LT(report.evaluations, 45);
}

TEST(CompactLbfgs, HasTheSameBitsForAnyNumberOfThreads) {
  const auto end_of = [](int threads) {
    use_threads(threads);
    Eigen::VectorXd last;
    const Objective objective = [&](const Eigen::VectorXd& y, Eigen::VectorXd& gradient) {
      last = y;
      return valley(y, gradient);
    };
    descend(objective, valley_start(20001 * 2), {30, 8, DescentMethod::compact_lbfgs});
    use_threads(1);
    return last;
  };
  EXPECT_EQ(end_of(1), end_of(3));
}

TEST(CompactLbfgs, StepsBackFromWhereThereIsNoValue) {
  const Objective objective = [](const Eigen::VectorXd& y, Eigen::VectorXd& gradient) {
    gradient = Eigen::VectorXd::Constant(1, -1 - 1 / (y[0] - 2));  // of -y - log(2 - y)
    return Evaluation{y[0] < 2 ? -y[0] - std::log(2 - y[0]) : std::nan(""),
                      std::abs(y[0] - 1) < 1e-6};
  };
  const Eigen::VectorXd start = Eigen::VectorXd::Constant(1, -100);
  const DescentReport report = descend(objective, start, {100, 20, DescentMethod::compact_lbfgs});
  EXPECT_EQ(report.end, DescentEnd::good_enough);
}

}  // namespace
}  // namespace wirepack
