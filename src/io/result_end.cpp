#include "wirepack/io/result_end.hpp"

#include "wirepack/packing/own_units.hpp"

namespace wirepack {

std::optional<StopReason> end_of(const Hdf5Reader& reader, const Scenario& scenario) {
  if (const auto limit = reached_limit(in_own_units(scenario), reader.progress())) return limit;
  const std::string reason = reader.stop_reason();
  for (const StopReason lost : {StopReason::no_equilibrium, StopReason::strands_passed}) {
    if (reason == name_of(lost)) return lost;
  }
  return std::nullopt;
}

bool found_no_equilibrium(StopReason reason) {
  return reason == StopReason::no_equilibrium || reason == StopReason::strands_passed;
}

PackingProgress place_to_go_on(const Hdf5Reader& reader) {
  bool at_limit = reader.finished();
  for (const StopReason lost : {StopReason::no_equilibrium, StopReason::strands_passed}) {
    at_limit = at_limit && reader.stop_reason() != name_of(lost);
  }
  const std::optional<PackingProgress> before = at_limit ? reader.progress_before() : std::nullopt;
  return before ? *before : reader.progress();
}

}  // namespace wirepack
