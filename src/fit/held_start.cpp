#include "held_start.hpp"

#include <utility>

#include "curve_problem.hpp"

namespace wirepack {

FitStart held_start(const MeasuredPoints& points, FitStart start) {
  constexpr int iterations = 12;
  MeasuredPoints held = points;
  held.arc = start.feet;
  FitStart nearer = continued(solve_curve(held, start, 0, iterations));
  nearer.feet = std::move(start.feet);
  return nearer;
}

}  // namespace wirepack
