#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/packing/advance.hpp"
#include "wirepack/packing/history.hpp"
#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/packing_progress.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

struct PackingModel;

/// Smallest part of an increment that is tried. An increment that fails is halved; the run ends if
/// this part fails too.
inline constexpr double smallest_substep = 1.0 / 64;

/// One quasi-static packing run, an increment at a time. The caller records the rows, and may stop
/// or save `progress()` between any two increments.
class QuasistaticPacking {
 public:
  /// Starts from a straight wire in the nozzle. `extra` are energy terms of the caller's own, by
  /// reference. Throws InvalidInput when the scenario is not valid.
  explicit QuasistaticPacking(const Scenario& scenario, const EnergyTerms& extra = {});
  ~QuasistaticPacking();
  QuasistaticPacking(QuasistaticPacking&&) noexcept;
  /// Continues from a saved progress of the same scenario.
  QuasistaticPacking(const Scenario& scenario, PackingProgress progress,
                     const EnergyTerms& extra = {});

  /// Runs the next increment. After no_equilibrium or strands_passed there is no row, and the
  /// progress is that of the last good increment. Throws NumericalFailure.
  Advance advance();

  const PackingProgress& progress() const { return progress_; }
  /// True if phi has grown by output.frame_every_density since the last frame was taken.
  bool frame_is_due() const;
  PackingFrame take_frame();

 private:
  std::unique_ptr<PackingModel> model_;
  PackingProgress progress_;
};

}  // namespace wirepack
