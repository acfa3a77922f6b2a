#pragma once

#include <variant>

#include "wirepack/packing/dynamic_packing.hpp"
#include "wirepack/packing/quasistatic_packing.hpp"

namespace wirepack {

/// One packing run by the method of its scenario; see QuasistaticPacking and DynamicPacking.
class PackingRun {
 public:
  explicit PackingRun(const Scenario& scenario) : run_(begun(scenario)) {}
  PackingRun(const Scenario& scenario, PackingProgress progress)
      : run_(continued(scenario, std::move(progress))) {}

  std::optional<StopReason> advance() {
    return std::visit([](auto& run) { return run.advance(); }, run_);
  }
  const PackingProgress& progress() const {
    return std::visit([](const auto& run) -> const PackingProgress& { return run.progress(); },
                      run_);
  }
  bool frame_is_due() const {
    return std::visit([](const auto& run) { return run.frame_is_due(); }, run_);
  }
  PackingFrame take_frame() {
    return std::visit([](auto& run) { return run.take_frame(); }, run_);
  }

 private:
  using Run = std::variant<QuasistaticPacking, DynamicPacking>;
  static Run begun(const Scenario& scenario) {
    if (scenario.method == Method::dynamic) return DynamicPacking(scenario);
    return QuasistaticPacking(scenario);
  }
  static Run continued(const Scenario& scenario, PackingProgress progress) {
    if (scenario.method == Method::dynamic) return DynamicPacking(scenario, std::move(progress));
    return QuasistaticPacking(scenario, std::move(progress));
  }

  Run run_;
};

}  // namespace wirepack
