#pragma once

#include <optional>

#include "wirepack/packing/history.hpp"
#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/packing_progress.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// Why a run ended.
enum class StopReason {
  scaled_force,
  force,
  density,
  length,
  increments,
  no_equilibrium,  ///< no minimum found, even in the smallest substep
  strands_passed,  ///< strands pass through each other even in the smallest substep
};
std::string_view name_of(StopReason reason);

/// One quasi-static packing run, an increment at a time; the caller records what it gets and can
/// stop or save `progress()` between any two increments. Feed, minimize, check, observe.
class QuasistaticPacking {
 public:
  /// From a straight wire in the nozzle. Throws InvalidInput when the scenario is not valid.
  explicit QuasistaticPacking(const Scenario& scenario);
  /// Goes on from a saved progress of the same scenario.
  QuasistaticPacking(const Scenario& scenario, PackingProgress progress);

  /// The next increment; afterwards progress().last is its row (wall_seconds is the caller's).
  /// Returns why the run is over, if it is; after no_equilibrium or strands_passed the progress is
  /// that of the last good increment. Throws NumericalFailure.
  std::optional<StopReason> advance();

  const PackingProgress& progress() const { return progress_; }
  /// phi has grown by output.frame_every_density since the last frame that was taken.
  bool frame_is_due() const;
  PackingFrame take_frame();

 private:
  Scenario scenario_;
  PackingProgress progress_;
};

}  // namespace wirepack
