#include "curve_choice.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <utility>

#include "wirepack/core/error.hpp"

#include "block_means.hpp"
#include "fit_uncertainty.hpp"
#include "held_start.hpp"
#include "helix_starts.hpp"
#include "line_of_parts.hpp"
#include "misfit.hpp"
#include "point_sample.hpp"
#include "spline_start.hpp"

namespace wirepack {

namespace {

constexpr Index most_trial_points = 200;  // on which starts compete

struct Trial {
  const FitStart* start;
  double cost, length;
};

// The shortest of those that fit about as well as the best. A helix of very dense turns is near any
// point of its cylinder, so that its residuals are only those across it: half the squares of the
// right one, whatever the points.
const FitStart& best_of(const std::vector<Trial>& trials, Index points) {
  constexpr double as_well = 2.5;
  const double round_off = 1e-22 * static_cast<double>(points);
  double least = std::numeric_limits<double>::infinity();
  for (const Trial& one : trials) least = std::min(least, one.cost);
  const auto fits = [&](const Trial& t) { return t.cost <= as_well * least + round_off; };
  const Trial* best = &trials.front();
  for (const Trial& one : trials) {
    if (!fits(one)) continue;
    const bool much_shorter = one.length < 0.9 * best->length;
    const bool much_longer = one.length > best->length / 0.9;
    if (!fits(*best) || much_shorter || (!much_longer && one.cost < best->cost)) best = &one;
  }
  return *best->start;
}

// All starts compete on a sample of the points, first for a few steps, then the better ones.
CurveSolution best_of(const MeasuredPoints& points, const std::vector<FitStart>& starts) {
  if (starts.size() == 1) return solve_curve(points, starts.front());
  const std::vector<Index> which = point_sample(points.count(), most_trial_points);
  const MeasuredPoints few = chosen(points, which);
  std::vector<Trial> trials;
  for (const FitStart& start : starts) trials.push_back({&start, 0, 0});
  for (const int iterations : {4, 40}) {
    for (Trial& trial : trials) {
      FitStart start = *trial.start;
      start.feet = trial.start->feet(which);
      const CurveSolution solution = solve_curve(few, start, 0, iterations);
      trial.cost = solution.cost;
      trial.length = solution.feet.maxCoeff() - solution.feet.minCoeff();
    }
    std::stable_sort(trials.begin(), trials.end(),
                     [](const Trial& p, const Trial& q) { return p.cost < q.cost; });
    trials.resize(std::min<std::size_t>(trials.size(), 6), trials.front());
  }
  return solve_curve(points, best_of(trials, few.count()));
}

// Arcs that are known stay what they are.
void keep_arcs(const MeasuredPoints& points, FitStart& start) {
  if (points.arc.size() == 0) return;
  start.feet = points.arc;
  start.basis.first = points.arc.minCoeff();
  start.basis.last = points.arc.maxCoeff();
}

// Of some lines along means of the points, one and a number of intervals by Schwarz's criterion.
FitStart best_start(const MeasuredPoints& points, const BlockMeans& blocks,
                    const std::vector<StartLine>& lines, const std::optional<Index>& intervals) {
  constexpr Index most_intervals = 96;
  const MeasuredPoints& means = blocks.points;
  const Index residuals = (points.arc.size() > 0 ? 3 : 2) * means.count();
  const StartLine* best = &lines.front();
  Index best_intervals = 1;
  double least = std::numeric_limits<double>::infinity();
  for (const StartLine& line : lines) {
    const SplineStart start(means, line);
    const Index most = std::min({means.count() / 4, line.intervals, most_intervals});
    int worse = 0;
    for (const Index trial_intervals :
         intervals ? std::vector<Index>{*intervals} : interval_ladder(most)) {
      FitStart trial = start.with_intervals(trial_intervals);
      keep_arcs(means, trial);
      if (points.arc.size() == 0) trial = held_start(means, std::move(trial));
      const CurveSolution solution = solve_curve(means, trial, 0, 30);
      const double criterion = schwarz_criterion(2 * solution.cost, residuals, trial.basis.size());
      if (criterion < least) {
        least = criterion;
        best = &line;
        best_intervals = trial_intervals;
        worse = 0;
      } else if (++worse >= 3 && neighbour_correlation(solution) < 0.2) {
        break;  // what is left is scatter
      }
    }
  }
  const StartLine line{best->samples, best->place(blocks.of_point), best->intervals};
  const FitStart start = SplineStart(points, line).with_intervals(best_intervals);
  return points.arc.size() > 0 ? start : held_start(points, start);
}

FitStart start_of_part(const MeasuredPoints& points, const std::optional<Index>& intervals) {
  const BlockMeans blocks = block_means(points);
  const std::vector<StartLine> lines{smoothed_line(blocks.points), line_through(blocks.points)};
  return best_start(points, blocks, lines, intervals);
}

// Means of numbers of all points over their blocks.
Eigen::VectorXd means_over(const BlockMeans& blocks, const Eigen::VectorXd& numbers) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(blocks.points.count()), count = sum;
  for (Index i = 0; i < numbers.size(); ++i) {
    const Index b = blocks.of_point[static_cast<std::size_t>(i)];
    sum[b] += numbers[i];
    count[b] += 1;
  }
  return sum.cwiseQuotient(count);
}

FitStart spline_start(const MeasuredPoints& points, const std::optional<Index>& intervals) {
  if (points.arc.size() > 0) return start_of_part(points, intervals);
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
  const double first = solution.feet.minCoeff(), last = solution.feet.maxCoeff();
  double curvature = 0;
  constexpr Index samples = 1000;
  for (Index i = 0; i < samples; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / samples;
    curvature += solution.curve.darboux(first + share * (last - first)).norm() / samples;
  }
  const double turns = curvature * before / (2 * pi);
  if (turns < fewest_turns_of_parts || std::abs(last - first - before) * curvature < pi) return;
  throw InvalidInput(fmt::format(
      "the points cannot tell the shape: they wind {:.0f} times, and the spline found runs along "
      "other turns; more points to a turn, a part of them, or their arc lengths may do; a coil is "
      "a helix",
      turns));
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

MeasuredPoints chosen(const MeasuredPoints& points, const std::vector<Index>& which) {
  MeasuredPoints result;
  result.ordered = points.ordered;
  result.resolution = points.resolution;
  result.position = points.position(Eigen::all, which);
  if (points.arc.size() > 0) result.arc = points.arc(which);
  if (points.sigma.size() > 0) result.sigma = points.sigma(which);
  for (const Index i : which) {
    if (!points.line.empty()) result.line.push_back(points.line[static_cast<std::size_t>(i)]);
  }
  return result;
}

CurveSolution nearest_curve(const MeasuredPoints& points, const FitOptions& options,
                            bool order_may_be_wrong) {
  std::vector<FitStart> starts = starts_of(points, options, order_may_be_wrong);
  for (FitStart& start : starts) keep_arcs(points, start);
  CurveSolution solution = best_of(points, starts);
  if (options.robust) {
    solution = refined(points, std::move(solution));
  } else if (!solution.converged) {
    // a start beside which points far off pull less
    solution = solve_curve(points, continued(refined(points, std::move(solution))));
  }
  if (options.model == ShapeModel::spline) check_turns(starts.front(), solution);
  return solution;
}

}  // namespace wirepack
