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

struct DescentOptions {
  int max_evaluations = 50;  ///< at least 1; NLopt may take one more in its line search
  int memory = 20;           ///< vector pairs of L-BFGS; NLopt's own choice is 77 times slower
};

enum class DescentEnd { good_enough, evaluation_limit, gave_up };

struct DescentReport {
  DescentEnd end;
  int evaluations;
};

/// Descends from y = `start` with NLopt's L-BFGS (Nocedal, Luksan) until the objective calls a
/// point good enough, the limit is reached or the library gives up. Its return codes certify
/// nothing near round-off, so the caller judges by what its objective has seen. Exceptions of the
/// objective and non-finite values end the descent; exceptions are passed on.
DescentReport descend(const Objective& objective, const Eigen::VectorXd& start,
                      const DescentOptions& options);

}  // namespace wirepack
