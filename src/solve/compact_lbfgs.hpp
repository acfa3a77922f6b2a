#pragma once

#include "wirepack/solve/minimizer.hpp"

namespace wirepack {

// descend() by L-BFGS in its compact form. Sums over unknowns are taken tile by tile, so the bits
// do not depend on the number of threads. Steps fulfil the weak Wolfe conditions; 1 is tried first.
DescentReport compact_lbfgs(const Objective& objective, const Eigen::VectorXd& start,
                            const DescentOptions& options);

}  // namespace wirepack
