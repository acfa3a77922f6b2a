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

/// An increment is taken in halves where it fails; a part this small that fails ends the run.
inline constexpr double smallest_substep = 1.0 / 64;

/// One quasi-static packing run, an increment at a time; the caller records what it gets and can
/// stop or save `progress()` between any two increments. Feed, minimize, check, observe.
class QuasistaticPacking {
 public:
  /// From a straight wire in the nozzle. `extra` are energy terms of the caller's own, by
  /// reference. Throws InvalidInput when the scenario is not valid.
  explicit QuasistaticPacking(const Scenario& scenario, const EnergyTerms& extra = {});
  ~QuasistaticPacking();
  QuasistaticPacking(QuasistaticPacking&&) noexcept;
  /// Goes on from a saved progress of the same scenario.
  QuasistaticPacking(const Scenario& scenario, PackingProgress progress,
                     const EnergyTerms& extra = {});

  /// The next increment. After no_equilibrium or strands_passed it has no row, and the progress is
  /// that of the last good increment. Throws NumericalFailure.
  Advance advance();

  const PackingProgress& progress() const { return progress_; }
  /// phi has grown by output.frame_every_density since the last frame that was taken.
  bool frame_is_due() const;
  PackingFrame take_frame();

 private:
  std::unique_ptr<PackingModel> model_;
  PackingProgress progress_;
};

}  // namespace wirepack
