#include "interval_ladder.hpp"

#include <algorithm>
#include <cmath>

#include "wirepack/fit/shape_fit.hpp"

namespace wirepack {

std::vector<Index> interval_ladder(Index most) {
  const Index limit = std::min(most, most_intervals);
  std::vector<Index> ladder{1};
  for (Index power = 2; power <= limit; power *= 2) {
    ladder.push_back(power);
    if (power * 3 / 2 <= limit) ladder.push_back(power * 3 / 2);
  }
  return ladder;
}

double schwarz_criterion(double sum_of_squares, Index residuals, Index unknowns) {
  const auto n = static_cast<double>(residuals);
  return n * std::log(sum_of_squares / n + 1e-22) + static_cast<double>(unknowns) * std::log(n);
}

}  // namespace wirepack
