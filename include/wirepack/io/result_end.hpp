#pragma once

#include <optional>

#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/packing/stop_rule.hpp"

namespace wirepack {

/// Why the run of a result ended. Nothing: it is not finished.
std::optional<StopReason> stop_reason_of(const Hdf5Reader& reader);

/// How a result ends by the limits of a scenario, which need not be those it was made with: the
/// limit it has reached, or why there was nothing behind its last increment. Nothing: it can go on.
/// Throws FileError when the result is damaged.
std::optional<StopReason> end_of(const Hdf5Reader& reader, const Scenario& scenario);

/// The run found no way on: a result, but none that has reached a limit.
bool found_no_equilibrium(StopReason reason);

/// Where a run goes on with a result, to the same bits as an undisturbed one: at its last
/// increment; or before that, if a limit has ended it there, which may have cut the increment
/// short.
PackingProgress place_to_go_on(const Hdf5Reader& reader);

}  // namespace wirepack
