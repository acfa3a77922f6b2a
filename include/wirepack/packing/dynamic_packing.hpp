#pragma once

#include <memory>
#include <optional>

#include "wirepack/core/error.hpp"
#include "wirepack/packing/advance.hpp"
#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/packing_progress.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// Energies of an increment do not add up, as the time step is too long.
class UnstableIntegration : public NumericalFailure {
 public:
  UnstableIntegration(double increment, double inserted_length, double time_step);
  double increment() const { return increment_; }
  double inserted_length() const { return inserted_length_; }  ///< [length]
  double time_step() const { return time_step_; }              ///< [time]

 private:
  double increment_, inserted_length_, time_step_;
};

struct DynamicModel;  // its parameters as computations need them

/// One packing run in time (Stoop et al. 2011): the rest length of the inlet edge grows at a
/// constant speed, nodes and edge spins are integrated with the 6-value Gear scheme, strands and
/// wall rub with stick-slip friction, small viscous forces take out vibrations. A row for each
/// increment of length; its force is the mean injection force over the increment. Limits of the
/// force count once a first coil is inside.
class DynamicPacking {
 public:
  /// From a straight wire in the nozzle. Throws InvalidInput when the scenario is not valid.
  explicit DynamicPacking(const Scenario& scenario);
  /// Goes on from a saved progress of the same scenario.
  DynamicPacking(const Scenario& scenario, PackingProgress progress);
  ~DynamicPacking();
  DynamicPacking(DynamicPacking&&) noexcept;

  /// The next increment; it has no row after strands_passed. Throws UnstableIntegration and other
  /// NumericalFailures. Then, and without a row, the progress is that of the last good increment.
  Advance advance();

  const PackingProgress& progress() const { return progress_; }
  bool frame_is_due() const;
  PackingFrame take_frame();

 private:
  std::unique_ptr<DynamicModel> model_;
  PackingProgress progress_;
};

}  // namespace wirepack
