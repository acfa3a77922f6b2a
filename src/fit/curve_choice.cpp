#include "curve_choice.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "block_means.hpp"
#include "fit_uncertainty.hpp"
#include "helix_starts.hpp"
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
// point of its cylinder, so that its residuals are only those across it: half the squares of the right
// one, whatever the points.
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

// The line and the number of intervals by Schwarz's criterion, on means of successive points.
struct SplineChoice {
  SplineLine line = SplineLine::smoothed;
  Index intervals = 1;
};

SplineChoice chosen_spline(const MeasuredPoints& points, const std::optional<Index>& intervals) {
  constexpr Index most_intervals = 96;
  const MeasuredPoints means = block_means(points).points;
  const Index residuals = (points.arc.size() > 0 ? 3 : 2) * means.count();
  SplineChoice best;
  double least = std::numeric_limits<double>::infinity();
  for (const SplineLine line : {SplineLine::smoothed, SplineLine::through_points}) {
    const SplineStart start(means, line);
    const Index most = std::min({means.count() / 4, start.intervals(), most_intervals});
    int worse = 0;
    for (const Index trial_intervals :
         intervals ? std::vector<Index>{*intervals} : interval_ladder(most)) {
      FitStart trial = start.with_intervals(trial_intervals);
      keep_arcs(means, trial);
      const CurveSolution solution = solve_curve(means, trial, 0, 30);
      const double criterion = schwarz_criterion(2 * solution.cost, residuals, trial.basis.size());
      if (criterion < least) {
        least = criterion;
        best = {line, trial_intervals};
        worse = 0;
      } else if (++worse >= 3 && neighbour_correlation(solution) < 0.2) {
        break;  // what is left is scatter
      }
    }
  }
  return best;
}

CurveSolution refined(const MeasuredPoints& points, CurveSolution solution) {
  for (int round = 0; round < 3; ++round) {
    const double scale = points.sigma.size() > 0 ? 1 : median_scale(solution, solution.rows);
    if (!(scale > 0)) break;
    solution = solve_curve(points, continued(solution), 2 * scale);
  }
  return solution;
}

std::vector<FitStart> starts_of(const MeasuredPoints& points, const FitOptions& options,
                                bool order_may_be_wrong) {
  if (options.model == ShapeModel::circle) return {circle_start(points)};
  if (options.model == ShapeModel::spline) {
    const SplineChoice choice = chosen_spline(points, options.intervals);
    return {SplineStart(points, choice.line).with_intervals(choice.intervals)};
  }
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
  if (options.robust) return refined(points, std::move(solution));
  if (solution.converged) return solution;
  // a start beside which points far off pull less
  return solve_curve(points, continued(refined(points, std::move(solution))));
}

}  // namespace wirepack
