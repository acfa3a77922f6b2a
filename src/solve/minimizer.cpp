#include "wirepack/solve/minimizer.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <nlopt.hpp>
#include <vector>

#include "compact_lbfgs.hpp"

namespace wirepack {

namespace {

struct Descent {
  const Objective* objective;
  nlopt::opt* optimizer;
  Eigen::VectorXd y, gradient;
  bool good_enough = false;
  int evaluations = 0;
  std::exception_ptr exception;
};

// NLopt would turn an exception or a NaN into a generic failure after many more calls.
double call_objective(unsigned n, const double* y, double* gradient, void* data) noexcept {
  auto& descent = *static_cast<Descent*>(data);
  const auto size = static_cast<Index>(n);
  double value = HUGE_VAL;
  try {
    descent.y = Eigen::Map<const Eigen::VectorXd>(y, size);
    const Evaluation evaluation = (*descent.objective)(descent.y, descent.gradient);
    ++descent.evaluations;
    value = evaluation.value;
    descent.good_enough = evaluation.good_enough;
    const bool finite = std::isfinite(value) && descent.gradient.allFinite();
    if (descent.good_enough || !finite) descent.optimizer->force_stop();
    if (gradient != nullptr) {
      if (finite) {
        Eigen::Map<Eigen::VectorXd>(gradient, size) = descent.gradient;
      } else {
        std::fill_n(gradient, n, 0.0);
      }
    }
    if (!finite) value = HUGE_VAL;
  } catch (...) {
    descent.exception = std::current_exception();
    descent.optimizer->force_stop();
    if (gradient != nullptr) std::fill_n(gradient, n, 0.0);
  }
  return value;
}

DescentReport nlopt_lbfgs(const Objective& objective, const Eigen::VectorXd& start,
                          const DescentOptions& options) {
  nlopt::opt optimizer(nlopt::LD_LBFGS, static_cast<unsigned>(start.size()));
  Descent descent;
  descent.objective = &objective;
  descent.optimizer = &optimizer;
  optimizer.set_min_objective(call_objective, &descent);
  optimizer.set_maxeval(options.max_evaluations);
  optimizer.set_vector_storage(static_cast<unsigned>(options.memory));
  std::vector<double> y(start.data(), start.data() + start.size());
  double value = 0;
  try {
    optimizer.optimize(y, value);
  } catch (const std::exception&) {
    // forced_stop, round-off or generic failure: what the objective saw decides
  }
  if (descent.exception) std::rethrow_exception(descent.exception);
  const DescentEnd end = descent.good_enough ? DescentEnd::good_enough
                         : descent.evaluations >= options.max_evaluations
                             ? DescentEnd::evaluation_limit
                             : DescentEnd::gave_up;
  return {end, descent.evaluations};
}

}  // namespace

DescentReport descend(const Objective& objective, const Eigen::VectorXd& start,
                      const DescentOptions& options) {
  switch (options.method) {
    case DescentMethod::compact_lbfgs:
      return compact_lbfgs(objective, start, options);
    case DescentMethod::nlopt_lbfgs:
      break;
  }
  return nlopt_lbfgs(objective, start, options);
}

}  // namespace wirepack
