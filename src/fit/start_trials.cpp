#include "start_trials.hpp"

#include <algorithm>
#include <limits>

#include "chosen_points.hpp"
#include "point_sample.hpp"

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

}  // namespace

CurveSolution solved_from_best(const MeasuredPoints& points, const std::vector<FitStart>& starts) {
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
      trial.length = solution.length();
    }
    std::stable_sort(trials.begin(), trials.end(),
                     [](const Trial& p, const Trial& q) { return p.cost < q.cost; });
    trials.resize(std::min<std::size_t>(trials.size(), 6), trials.front());
  }
  return solve_curve(points, best_of(trials, few.count()));
}

}  // namespace wirepack
