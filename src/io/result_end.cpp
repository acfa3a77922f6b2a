#include "wirepack/io/result_end.hpp"

#include <array>

#include "wirepack/packing/own_units.hpp"

namespace wirepack {

namespace {

constexpr std::array all_stop_reasons{StopReason::scaled_force,  StopReason::force,
                                      StopReason::density,       StopReason::length,
                                      StopReason::increments,    StopReason::no_equilibrium,
                                      StopReason::strands_passed};

}  // namespace

std::optional<StopReason> stop_reason_of(const Hdf5Reader& reader) {
  const std::string name = reader.stop_reason();
  for (const StopReason reason : all_stop_reasons) {
    if (name == name_of(reason)) return reason;
  }
  return std::nullopt;
}

std::optional<StopReason> end_of(const Hdf5Reader& reader, const Scenario& scenario) {
  if (const auto limit = reached_limit(in_own_units(scenario), reader.progress())) return limit;
  const std::optional<StopReason> reason = stop_reason_of(reader);
  return reason && found_no_equilibrium(*reason) ? reason : std::nullopt;
}

bool found_no_equilibrium(StopReason reason) {
  return reason == StopReason::no_equilibrium || reason == StopReason::strands_passed;
}

PackingProgress place_to_go_on(const Hdf5Reader& reader) {
  const std::optional<StopReason> reason = stop_reason_of(reader);
  const bool at_limit = reason && !found_no_equilibrium(*reason);
  const std::optional<PackingProgress> before = at_limit ? reader.progress_before() : std::nullopt;
  return before ? *before : reader.progress();
}

}  // namespace wirepack
