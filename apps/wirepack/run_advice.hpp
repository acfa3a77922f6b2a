#pragma once

#include <optional>
#include <string>
#include <vector>

#include "wirepack/packing/scenario.hpp"
#include "wirepack/packing/stop_rule.hpp"

namespace wirepack {

/// What to do with a result after a run, as a line that starts with '#'. Nothing as `stop`: it was
/// stopped before its end.
std::string next_step(std::optional<StopReason> stop, const std::string& file);

/// What to try when no equilibrium was found, or strands have passed.
std::string what_to_try(const Scenario& scenario, StopReason reason);

/// Says each warning on a line of its own on stderr.
void say_warnings(const std::string& command, const std::vector<std::string>& warnings);

/// Size and time of a run to this length.
struct RunEstimate {
  double nodes, increments, frames;
  double bytes;    ///< of the result file
  double seconds;  ///< on one core of the 2020s; a guess within a factor of three
};
RunEstimate estimate(const Scenario& scenario, double length);

/// Throws InvalidInput, with the estimate, when a run to this length is plainly impossible: no
/// machine has the memory or the disk, or a life is too short.
void require_possible(const Scenario& scenario, double length);

}  // namespace wirepack
