#include "spline_choice.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "block_means.hpp"
#include "curve_problem.hpp"
#include "held_start.hpp"
#include "interval_ladder.hpp"
#include "line_of_parts.hpp"
#include "misfit.hpp"
#include "spline_start.hpp"

namespace wirepack {

namespace {

struct SplineChoice {
  const StartLine* line;
  Index intervals;
};

// Of some lines along means of the points, one and a number of intervals by Schwarz's criterion.
SplineChoice best_choice(const MeasuredPoints& means, const std::vector<StartLine>& lines,
                         const std::optional<Index>& intervals) {
  const bool arcs_known = means.arc.size() > 0;
  const Index residuals = (arcs_known ? 3 : 2) * means.count();
  SplineChoice best{&lines.front(), 1};
  double least = std::numeric_limits<double>::infinity();
  for (const StartLine& line : lines) {
    const SplineStart start(means, line);
    const Index most = std::min(means.count() / 4, line.intervals);
    int worse = 0;
    for (const Index trial_intervals :
         intervals ? std::vector<Index>{*intervals} : interval_ladder(most)) {
      FitStart trial = start.with_intervals(trial_intervals);
      keep_arcs(means, trial);
      if (!arcs_known) trial = held_start(means, std::move(trial));
      const CurveSolution solution = solve_curve(means, trial, 0, 30);
      const double criterion = schwarz_criterion(2 * solution.cost, residuals, trial.basis.size());
      if (criterion < least) {
        least = criterion;
        best = {&line, trial_intervals};
        worse = 0;
      } else if (++worse >= 3 && neighbour_correlation(solution) < 0.2) {
        break;  // what is left is scatter
      }
    }
  }
  return best;
}

FitStart best_start(const MeasuredPoints& points, const BlockMeans& blocks,
                    const std::vector<StartLine>& lines, const std::optional<Index>& intervals) {
  const SplineChoice best = best_choice(blocks.points, lines, intervals);
  const StartLine line{best.line->samples, best.line->place(blocks.of_point), best.line->intervals};
  const FitStart start = SplineStart(points, line).with_intervals(best.intervals);
  return points.arc.size() > 0 ? start : held_start(points, start);
}

FitStart start_of_part(const MeasuredPoints& points, const std::optional<Index>& intervals,
                       Index most_means = most_block_means) {
  const BlockMeans blocks = block_means(points, most_means);
  const std::vector<StartLine> lines{smoothed_line(blocks.points), line_through(blocks.points)};
  return best_start(points, blocks, lines, intervals);
}

}  // namespace

FitStart spline_start(const MeasuredPoints& points, const std::optional<Index>& intervals,
                      Index most_means) {
  // a zigzag would count as turns of a coil, which its parts are found by
  const bool one_part = points.arc.size() > 0 || most_means < most_block_means;
  if (one_part) return start_of_part(points, intervals, most_means);
  constexpr Index most = 10 * most_block_means, of_turn = 16;
  const BlockMeans fine = block_means(points, most);
  std::optional<LineOfParts> found = line_of_parts(fine.points, [](const MeasuredPoints& part) {
    return solve_curve(part, start_of_part(part, {}));
  });
  if (!found) return start_of_part(points, intervals);
  const auto enough = static_cast<Index>(of_turn * found->turns);
  const BlockMeans blocks = block_means(points, std::clamp(enough, most_block_means, most));
  StartLine& line = found->line;
  line.place = means_over(blocks, line.place(fine.of_point));
  return best_start(points, blocks, {line}, intervals);
}

}  // namespace wirepack
