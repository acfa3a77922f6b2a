#include "wirepack/solve/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "descent_round.hpp"
#include "stopwatch.hpp"

namespace wirepack {

namespace {

// A round in which strands pass is repeated with half the guard's distance, down to this part of
// it.
constexpr double smallest_distance = 1.0 / 16;
// A snap can lead through hundreds of such rounds. After a few in a row that end at the guard, each
// further one may go twice as far, as long as none is taken back.
constexpr int rounds_of_a_snap = 4;
// The search ends after so many rounds in a row without gain. A round gains if it brings down the
// residual by a tenth, or the energy by more than its round-off.
constexpr int most_fruitless_rounds = 3;
constexpr double residual_gain = 0.9, energy_gain = 1e-14;

class Search {
 public:
  Search(RodState& state, const HeldUnknowns& held, const EnergyTerms& energy,
         const EquilibriumOptions& options)
      : held_(held),
        energy_(energy),
        options_(options),
        guard_distance_(options.guard.distance),
        longest_distance_(options.guard.snap_distance) {
    lowest_.state = std::move(state);
  }

  // Descends in rounds until the gradient is small enough, or nothing is gained any more.
  EquilibriumEnd run() {
    while (true) {
      const LowestPoint before = lowest_;
      auto [gain, at_guard, order] = descend();
      order_ = std::move(order);
      if (!admissible(before.state)) {
        if (const auto end = take_back(before)) return *end;
        continue;
      }
      set_guard_distance(at_guard);
      if (lowest_.residual <= 1 && lowest_.guard_energy == 0) return EquilibriumEnd::converged;
      if (spent()) return EquilibriumEnd::evaluation_limit;
      const bool gained = gain > energy_gain * std::abs(double(lowest_.energy)) ||
                          lowest_.residual < residual_gain * before.residual;
      fruitless_rounds_ = gained ? 0 : fruitless_rounds_ + 1;
      if (fruitless_rounds_ == most_fruitless_rounds) return EquilibriumEnd::stalled;
    }
  }
  const LowestPoint& lowest() const { return lowest_; }
  RodState take_state() { return std::move(lowest_.state); }
  const SolverWork& work() const { return work_; }
  std::vector<int> take_order() { return std::move(order_); }

 private:
  RoundReport descend() {
    const auto left = static_cast<int>(options_.method.max_evaluations - work_.evaluations);
    return descend_one_round(lowest_, held_, energy_, options_, guard_distance_,
                             std::min(options_.method.refactor_every, left), work_);
  }
  // After a round that is kept.
  void set_guard_distance(bool at_guard) {
    rounds_at_guard_ = at_guard ? rounds_at_guard_ + 1 : 0;
    const double shortest = options_.guard.distance;
    guard_distance_ = rounds_at_guard_ < rounds_of_a_snap
                          ? shortest
                          : std::max(shortest, std::min(2 * guard_distance_, longest_distance_));
  }
  // Goes back to the start of the round and halves the guard's distance. Returns the end of the
  // search if that is too short, or if the evaluations are used up.
  std::optional<EquilibriumEnd> take_back(const LowestPoint& before) {
    lowest_ = before;
    ++work_.rounds_taken_back;
    guard_distance_ /= 2;
    longest_distance_ = guard_distance_;
    if (guard_distance_ < smallest_distance * options_.guard.distance) {
      return EquilibriumEnd::inadmissible;
    }
    if (spent()) return EquilibriumEnd::evaluation_limit;
    return std::nullopt;
  }
  bool admissible(const RodState& before) {
    if (!options_.guard.admissible) return true;
    Stopwatch watch;
    const bool answer = options_.guard.admissible(before, lowest_.state);
    watch.lap(work_.passage_seconds);
    return answer;
  }
  bool spent() const { return work_.evaluations >= options_.method.max_evaluations; }

  const HeldUnknowns& held_;
  const EnergyTerms& energy_;
  const EquilibriumOptions& options_;
  LowestPoint lowest_;
  double guard_distance_;
  double longest_distance_;
  std::vector<int> order_;  // of elimination in the last round
  int rounds_at_guard_ = 0;
  int fruitless_rounds_ = 0;
  SolverWork work_;
};

}  // namespace

EquilibriumOptions equilibrium_options(double bend_stiffness, double length, double force_tolerance,
                                       const MinimizerOptions& method) {
  return {force_tolerance, force_tolerance * length,
          method.shift * bend_stiffness / (length * length * length), method};
}

EquilibriumReport solve_equilibrium(RodState& state, const HeldUnknowns& held,
                                    const EnergyTerms& energy, const EquilibriumOptions& options) {
  Search search(state, held, energy, options);
  EquilibriumReport report;
  report.end = search.run();
  report.energy = search.lowest().energy;
  report.residual = search.lowest().residual;
  report.inlet_length_force = search.lowest().inlet_length_force;
  report.work = search.work();
  report.order = search.take_order();
  state = search.take_state();
  return report;
}

}  // namespace wirepack
