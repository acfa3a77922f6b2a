#include "nozzle_problems.hpp"

#include <cmath>
#include <fmt/format.h>

#include "wirepack/packing/imperfection.hpp"

#include "scenario_numbers.hpp"

namespace wirepack {

namespace {

std::string shown(const Vec3& v) {
  return fmt::format("[{:.12g}, {:.12g}, {:.12g}]", v.x(), v.y(), v.z());
}

// The centre of a cavity is on no side of its wall: no normal, and nowhere to go from there.
std::string problem_of_position(const Scenario& scenario) {
  const Vec3& position = *scenario.nozzle.position;
  const double a = scenario.wire.radius;
  const std::string given = "nozzle.position = " + shown(position);
  if (!position.allFinite()) return given + ": must be three finite numbers, [x, y, z]";
  const bool at_centre = position.norm() <= round_off * a;
  if (at_centre && !scenario.nozzle.direction) {
    return given + ": needs nozzle.direction, as the wall has no normal there";
  }
  if (at_centre || wall_gap(scenario.cavity, position, a) >= -round_off * a) return {};
  const Vec3 inside = scenario.cavity.radius / 2 * position.stableNormalized();
  const Vec3 nearest = touching_point(scenario.cavity, inside, a);
  return fmt::format(
      "{}: must be where the wire fits; towards there from the centre, it touches the wall at {}",
      given, shown(nearest));
}

std::string problem_of_direction(const Vec3& direction) {
  if (direction.allFinite() && direction != Vec3::Zero()) return {};
  return "nozzle.direction = " + shown(direction) + ": must be three finite numbers, not all 0";
}

// A run starts with two straight edges in front of the nozzle.
std::string problem_of_start(const Scenario& scenario) {
  const Nozzle nozzle = drawn_setup(scenario).nozzle;
  const double a = scenario.wire.radius, l = scenario.wire.edge_length;
  const Vec3 tip = nozzle.position - 2 * l * nozzle.direction;
  const double tolerance = round_off * a;
  const bool mouth_fits = wall_gap(scenario.cavity, nozzle.position, a) >= -tolerance;
  if (mouth_fits && wall_gap(scenario.cavity, tip, a) >= -tolerance) return {};
  const std::string tilted =
      scenario.imperfection.nozzle_tilt > 0 ? ", with the tilt of the seed," : "";
  if (scenario.nozzle.depth > 0) {
    return fmt::format(
        "nozzle.depth = {:g}:{} leaves no room for the first two edges, {:g}, in front of it",
        scenario.nozzle.depth, tilted, 2 * l);
  }
  return fmt::format(
      "nozzle.direction = {}:{} leads out of the cavity within the first two edges, {:g}",
      shown(scenario.nozzle.direction.value_or(-nozzle.direction)), tilted, 2 * l);
}

}  // namespace

void check_nozzle(const Scenario& scenario, std::vector<std::string>& found) {
  const NozzleOptions& nozzle = scenario.nozzle;
  const auto note = [&](const std::string& problem) {
    if (!problem.empty()) found.push_back(problem);
  };
  if (nozzle.direction) note(problem_of_direction(*nozzle.direction));
  if (!(std::isfinite(nozzle.depth) && nozzle.depth >= 0)) {
    note(fmt::format("nozzle.depth = {:g}: must be finite and not negative", nozzle.depth));
  }
  if (found.empty() && nozzle.position) note(problem_of_position(scenario));
  if (found.empty()) note(problem_of_start(scenario));
}

}  // namespace wirepack
