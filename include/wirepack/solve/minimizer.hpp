#pragma once

#include <functional>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// What an objective says of one point. `gradient` was set by the call.
struct Evaluation {
  double value;
  bool good_enough;  ///< by the caller's own test: stop here
};

using Objective = std::function<Evaluation(const Eigen::VectorXd& y, Eigen::VectorXd& gradient)>;

/// Two programs of one method. NLopt's (Nocedal, Luksan) goes through the pairs of L-BFGS one after
/// the other. The compact form (Byrd, Nocedal and Schnabel, Math. Program. 63, 129, 1994, Eq. 3.1)
/// has the same inverse Hessian as a product with all pairs, in registers and, if long, threads.
enum class DescentMethod { nlopt_lbfgs, compact_lbfgs };

struct DescentOptions {
  int max_evaluations = 50;  ///< at least 1; NLopt may take one more in its line search
  int memory = 20;  ///< pairs of vectors, at least 1; NLopt's own choice is 77 times slower
  DescentMethod method = DescentMethod::nlopt_lbfgs;
};

enum class DescentEnd { good_enough, evaluation_limit, gave_up };

struct DescentReport {
  DescentEnd end;
  int evaluations;
};

/// Descends from y = `start` by L-BFGS until the objective calls a point good enough, the limit is
/// reached or the method gives up. NLopt's return codes certify nothing near round-off, so the
/// caller judges by what its objective has seen. Exceptions of the objective are passed on. Values
/// that are not finite end a descent of NLopt; the compact form takes a shorter step.
DescentReport descend(const Objective& objective, const Eigen::VectorXd& start,
                      const DescentOptions& options);

}  // namespace wirepack
