#pragma once

#include <optional>

#include "wirepack/packing/history.hpp"
#include "wirepack/packing/stop_rule.hpp"

namespace wirepack {

/// What an increment has brought. The last one of a run has a row as well, unless no equilibrium
/// was found.
struct Advance {
  std::optional<HistoryRow> row;   ///< wall_seconds is the caller's
  std::optional<StopReason> stop;  ///< the run is over
};

}  // namespace wirepack
