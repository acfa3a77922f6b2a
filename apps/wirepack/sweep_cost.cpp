#include "sweep_cost.hpp"

#include <algorithm>
#include <array>

#include "wirepack/packing/longest_wire.hpp"

namespace wirepack {

namespace {

bool is_over(const TaskStatus& task) {
  return task.state == TaskState::done || task.state == TaskState::no_equilibrium;
}

// An increment costs in proportion to the wire that is inside.
double done_share(const TaskStatus& task) {
  if (is_over(task)) return 1;
  const double share = task.last.inserted_length / expected_length(task.scenario);
  return std::min(share * share, 0.99);
}

}  // namespace

double expected_cost(const Scenario& scenario) {
  const double length = expected_length(scenario);
  return length / scenario.insertion.increment * (length / scenario.wire.edge_length);
}

std::vector<double> seconds_left(const std::vector<TaskStatus>& tasks) {
  std::array<double, 2> seconds{}, cost{};  // by method
  for (const TaskStatus& task : tasks) {
    const auto method = static_cast<std::size_t>(task.scenario.method);
    if (task.last.wall_seconds <= 0) continue;
    seconds[method] += task.last.wall_seconds;
    cost[method] += done_share(task) * expected_cost(task.scenario);
  }
  std::vector<double> left;
  for (const TaskStatus& task : tasks) {
    const auto method = static_cast<std::size_t>(task.scenario.method);
    const double share = done_share(task);
    if (is_over(task)) {
      left.push_back(0);
    } else if (share > 0 && task.last.wall_seconds > 0) {
      left.push_back(task.last.wall_seconds * (1 - share) / share);
    } else if (cost[method] > 0) {
      left.push_back(expected_cost(task.scenario) * seconds[method] / cost[method]);
    } else {
      left.push_back(-1);
    }
  }
  return left;
}

}  // namespace wirepack
