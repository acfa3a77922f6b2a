#pragma once

#include <variant>

#include "wirepack/packing/advance.hpp"
#include "wirepack/packing/dynamic_packing.hpp"
#include "wirepack/packing/own_units.hpp"
#include "wirepack/packing/quasistatic_packing.hpp"

namespace wirepack {

/// One packing run by the method of its scenario, in any units: it is computed in units of its own
/// wire, so that the same scenario in other units is the same run. Rows and frames have the units
/// of the scenario, the progress those of the wire. See QuasistaticPacking and DynamicPacking.
class PackingRun {
 public:
  explicit PackingRun(const Scenario& scenario);
  /// Goes on from the progress of a PackingRun of the same scenario, in these or other units.
  PackingRun(const Scenario& scenario, PackingProgress progress);

  Advance advance();
  const PackingProgress& progress() const {
    return std::visit([](const auto& run) -> const PackingProgress& { return run.progress(); },
                      run_);
  }
  /// Of the last accepted increment.
  HistoryRow row() const { return in_units(progress().last, units_); }
  bool frame_is_due() const {
    return std::visit([](const auto& run) { return run.frame_is_due(); }, run_);
  }
  PackingFrame take_frame() {
    return in_units(std::visit([](auto& run) { return run.take_frame(); }, run_), units_);
  }

 private:
  using Run = std::variant<QuasistaticPacking, DynamicPacking>;

  Units units_;
  Run run_;
};

}  // namespace wirepack
