#pragma once

#include <vector>

#include "wirepack/io/sweep_status.hpp"

namespace wirepack {

/// What a whole run costs beside others of the same method: increments times nodes, by the length
/// at which it is expected to end. For an order and for guesses of time.
double expected_cost(const Scenario& scenario);

/// Seconds that each task still takes, by what the others and its own first part have taken. Zero
/// for finished tasks; negative where no run of its method has begun.
std::vector<double> seconds_left(const std::vector<TaskStatus>& tasks);

}  // namespace wirepack
