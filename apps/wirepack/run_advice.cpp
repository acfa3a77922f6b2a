#include "run_advice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>

#include "wirepack/core/error.hpp"
#include "wirepack/core/shell_quoted.hpp"
#include "wirepack/observe/packing_density.hpp"
#include "wirepack/packing/dynamics_values.hpp"

#include "terminal.hpp"

namespace wirepack {

std::string next_step(std::optional<StopReason> stop, const std::string& file) {
  if (!stop) return fmt::format("# next: the same command with --resume goes on\n");
  return fmt::format(
      "# next: wirepack view {0} makes a page to look at, wirepack analyze {0} "
      "tables of coils and order\n",
      shell_quoted(file));
}

std::string what_to_try(const Scenario& scenario, StopReason reason) {
  if (scenario.method == Method::dynamic) {
    return "a lower dynamics.insertion_speed or a shorter dynamics.time_step may help, from the "
           "beginning";
  }
  if (reason == StopReason::strands_passed) {
    return fmt::format(
        "go on by --resume with a shorter insertion.increment (it is {:.4g}), or "
        "begin again with a higher contact.stiffness",
        scenario.insertion.increment);
  }
  return fmt::format(
      "go on by --resume with other values: minimizer.tolerance ten times larger (it is {:.1g}), "
      "minimizer.max_evaluations larger (it is {}), or insertion.increment half as long (it is "
      "{:.4g})",
      scenario.minimizer.tolerance, scenario.minimizer.max_evaluations,
      scenario.insertion.increment);
}

namespace {

// Of a result file: what is there once, with two checkpoints of a small wire, and with each frame
// (groups and datasets of HDF5); a chunk of 256 rows of the history; a node of a frame with the
// contacts it has on average.
constexpr double bytes_once = 205e3, bytes_of_frame = 17.6e3, bytes_of_chunk = 39e3;
constexpr double rows_of_chunk = 256, bytes_of_node = 104;
// Time of an increment by node, measured at R = 5 to 20 up to phi = 0.75; above phi R / a = 4 snaps
// take most of it.
constexpr double seconds_of_increment_by_node = 2.5e-5, many_snaps = 4, growth = 5;
constexpr double seconds_of_step_by_node = 3.5e-7;
// Far beyond what has been run (some 1e5 nodes, 1 GB, days), as these are guesses: a node takes
// some kB of memory.
constexpr double most_nodes = 1e8, most_bytes = 1e13, year = 3.2e7, most_seconds = 100 * year;

}  // namespace

RunEstimate estimate(const Scenario& scenario, double length) {
  RunEstimate run{};
  run.nodes = length / scenario.wire.edge_length;
  run.increments = length / scenario.insertion.increment;
  const double density = packing_density(length, scenario.cavity, scenario.wire.radius);
  run.frames = density / scenario.output.frame_every_density + 1;
  const double mean_nodes = run.nodes / 2;
  run.bytes = bytes_once + bytes_of_frame * run.frames +
              bytes_of_chunk * std::ceil(run.increments / rows_of_chunk) +
              bytes_of_node * run.frames * mean_nodes;
  const double strands = density * scenario.cavity.radius / scenario.wire.radius;
  run.seconds = seconds_of_increment_by_node * run.increments * mean_nodes *
                (1 + std::pow(strands / many_snaps, growth));
  if (scenario.method == Method::dynamic) {
    const DynamicsValues values = dynamics_values(scenario);
    const double steps = length / (values.insertion_speed * values.time_step);
    run.seconds = seconds_of_step_by_node * steps * mean_nodes;
  }
  return run;
}

void require_possible(const Scenario& scenario, double length) {
  // A run with a limit beyond a full cavity ends before that, without an equilibrium.
  length = std::min(length, length_at_density(1, scenario.cavity, scenario.wire.radius));
  const RunEstimate run = estimate(scenario, length);
  if (run.nodes < most_nodes && run.bytes < most_bytes && run.seconds < most_seconds) return;
  throw InvalidInput(fmt::format(
      "a run at R = {:.4g} is impossible: about {:.2g} nodes, {:.2g} increments, {:.2g} frames, "
      "{:.2g} GB and "
      "{:.2g} years of computing to L = {:.3g}; possible are {:.0e} nodes, {:.0e} GB, {:.0f} "
      "years: a "
      "limit in [stop], a smaller cavity.radius over wire.radius, a longer wire.edge_length or "
      "insertion.increment, or a larger output.frame_every_density make it smaller",
      scenario.cavity.radius, run.nodes, run.increments, run.frames, run.bytes / 1e9,
      run.seconds / year, length, most_nodes, most_bytes / 1e9, most_seconds / year));
}

void say_warnings(const std::string& command, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    print_message(fmt::format("wirepack {}: warning: {}", command, warning));
  }
}

}  // namespace wirepack
