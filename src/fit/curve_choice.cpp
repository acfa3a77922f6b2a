#include "curve_choice.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>
#include <vector>

#include "block_means.hpp"
#include "cannot_tell.hpp"
#include "curve_places.hpp"
#include "fit_uncertainty.hpp"
#include "helix_starts.hpp"
#include "line_of_parts.hpp"
#include "spline_choice.hpp"
#include "start_trials.hpp"

namespace wirepack {

namespace {

constexpr Index fewest_means = 12;

CurveSolution refined(const MeasuredPoints& points, CurveSolution solution) {
  for (int round = 0; round < 3; ++round) {
    const double scale = points.sigma.size() > 0 ? 1 : median_scale(solution, solution.rows);
    if (!(scale > 0)) break;
    solution = solve_curve(points, continued(solution), 2 * scale);
  }
  return solution;
}

// Errors of k0 add up along a wire that winds often. Where its length has changed by half a turn
// since the start, feet have gone over to other turns.
void check_turns(const FitStart& start, const CurveSolution& solution) {
  if (!solution.converged || solution.rows == 3) return;
  const double before = start.feet.maxCoeff() - start.feet.minCoeff();
  const double curvature = mean_turning(solution.curve, solution.first(), solution.last(), 1000);
  const double turns = curvature * before / (2 * pi);
  const double turned_more = std::abs(solution.length() - before) * curvature;
  if (turns < fewest_turns_of_parts || turned_more < pi) return;
  throw cannot_tell(fmt::format(
      "they wind {:.0f} times, and the spline found runs along other turns; more points to a turn, "
      "a part of them, or their arc lengths may do; a coil is a helix",
      turns));
}

// The curve nearest to the points that is found from these starts.
CurveSolution solved(const MeasuredPoints& points, const FitOptions& options,
                     std::vector<FitStart>& starts) {
  for (FitStart& start : starts) keep_arcs(points, start);
  CurveSolution solution = solved_from_best(points, starts);
  if (options.robust) return refined(points, std::move(solution));
  if (solution.converged) return solution;
  // a start beside which points far off pull less
  return solve_curve(points, continued(refined(points, std::move(solution))));
}

std::vector<FitStart> starts_of(const MeasuredPoints& points, const FitOptions& options,
                                bool order_may_be_wrong) {
  if (options.model == ShapeModel::circle) return {circle_start(points)};
  if (options.model == ShapeModel::spline) return {spline_start(points, options.intervals)};
  std::vector<FitStart> starts = helix_starts(points);
  if (points.ordered && order_may_be_wrong) {
    MeasuredPoints loose = points;
    loose.ordered = false;
    const std::vector<FitStart> more = helix_starts(loose);
    starts.insert(starts.end(), more.begin(), more.end());
  }
  return starts;
}

}  // namespace

CurveSolution nearest_curve(const MeasuredPoints& points, const FitOptions& options,
                            bool order_may_be_wrong) {
  std::vector<FitStart> starts = starts_of(points, options, order_may_be_wrong);
  CurveSolution solution = solved(points, options, starts);
  if (options.model == ShapeModel::spline) {
    // Points that scatter as far as they are apart make a zigzag, which a spline must not follow:
    // it starts from means of more and more of them.
    for (Index means = std::min(points.count(), most_block_means) / 2;
         !solution.converged && means >= fewest_means; means /= 2) {
      starts = {spline_start(points, options.intervals, means)};
      solution = solved(points, options, starts);
    }
    check_turns(starts.front(), solution);
  }
  return solution;
}

}  // namespace wirepack
