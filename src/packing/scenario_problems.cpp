#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

#include "wirepack/core/value_problems.hpp"
#include "wirepack/observe/packing_density.hpp"
#include "wirepack/packing/dynamics_values.hpp"
#include "wirepack/packing/longest_wire.hpp"
#include "wirepack/packing/scenario.hpp"

#include "cavity_problems.hpp"
#include "nozzle_problems.hpp"
#include "scenario_numbers.hpp"

namespace wirepack {

namespace {

constexpr double largest_magnitude = 1e12;

// What is so far from its unit cannot be meant, and products would leave the range of numbers.
void check_magnitudes(const Scenario& scenario, std::vector<std::string>& found) {
  for_each_number_with_unit(scenario, [&](std::string_view key, double number, double unit) {
    // may be as far as it likes; each of three numbers as small
    if (key == "stop.length" || key == "nozzle.position") return;
    const double smallest = unit / largest_magnitude, largest = unit * largest_magnitude;
    if (number == 0 || (std::abs(number) >= smallest && std::abs(number) <= largest)) return;
    std::ostringstream text;
    text << key << " = " << number << ": its size must be between " << smallest << " and "
         << largest << ", 1e12 times less and more than " << unit
         << ", its unit by radius, modulus and density of the wire";
    found.push_back(text.str());
  });
}

void check_reference_shape(const Scenario& scenario, std::vector<std::string>& found) {
  const ReferenceShape& shape = scenario.wire.reference_shape;
  if (shape.empty()) return;
  double turning = 0, curvature = 0;  // largest
  for (const DarbouxRow& row : shape.table.rows()) {
    turning = std::max(turning, row.darboux.norm());
    curvature = std::max(curvature, row.darboux.head<2>().norm());
  }
  std::ostringstream text;
  if (!(scenario.wire.edge_length * turning <= 1 + round_off)) {
    text << "wire.edge_length = " << scenario.wire.edge_length << ": must be at most "
         << 1 / turning << ", as wire.reference_shape turns by a radian over that";
    if (curvature * scenario.wire.radius > 1) {
      text << "; it bends to a radius of " << 1 / curvature << ", the wire's own radius is "
           << scenario.wire.radius << ": are both in the same unit of length?";
    }
    found.push_back(text.str());
  }
  // lengths are sums of increments: round-off is allowed
  const double length = longest_wire(scenario);
  if (shape.beyond == BeyondShape::error && !(length <= shape.table.length() * (1 + round_off))) {
    text.str("");
    text << "wire.reference_shape_beyond = error: the shape is " << shape.table.length()
         << " long and the run may insert ";
    if (std::isfinite(length)) {
      text << length;
    } else {
      text << "any length";
    }
    text << "; must be repeat or extend, or stop.length at most that of the shape";
    if (shape.table.length() < scenario.wire.radius) {
      text << "; the wire's radius is " << scenario.wire.radius
           << ": are both in the same unit of length?";
    }
    found.push_back(text.str());
  }
}

void check_positive(std::string_view key, double value, std::vector<std::string>& found) {
  require(is_positive(value), key, value, must_be_positive, found);
}

void check_contacts(const Scenario& scenario, std::vector<std::string>& found) {
  check_positive("cavity.wall_stiffness", scenario.wall_stiffness, found);
  check_positive("contact.stiffness", scenario.contact.stiffness, found);
  check_positive("contact.excluded_arc_length", scenario.contact.excluded_arc_length, found);
}

void check_insertion(const Scenario& scenario, std::vector<std::string>& found) {
  const double l = scenario.wire.edge_length, increment = scenario.insertion.increment;
  require(increment >= l / 1000 * (1 - round_off) && increment <= l * (1 + round_off),
          "insertion.increment", increment,
          "must be at least a thousandth of wire.edge_length and at most all of it", found);
  const double perturbation = scenario.insertion.perturbation;
  require(perturbation >= 1e-9 && perturbation <= 0.1, "insertion.perturbation", perturbation,
          "must be between 1e-9 and 0.1 (wire radii): without one the wire does not buckle", found);
}

void check_stop(const Scenario& scenario, std::vector<std::string>& found) {
  const StopLimits& stop = scenario.stop;
  if (!stop.scaled_force && !stop.force && !stop.density && !stop.length && !stop.increments) {
    found.emplace_back(
        "stop = {}: needs at least one of scaled_force, force, density, length, increments");
  }
  if (stop.scaled_force) check_positive("stop.scaled_force", *stop.scaled_force, found);
  if (stop.force) check_positive("stop.force", *stop.force, found);
  // a run starts with two edges in the cavity
  const double start = 2 * scenario.wire.edge_length;
  if (stop.density) {
    const double least = packing_density(start, scenario.cavity, scenario.wire.radius);
    std::ostringstream allowed;
    allowed << "must be below 1 and above the density of the first two edges, " << least;
    require(*stop.density > least && *stop.density < 1, "stop.density", *stop.density,
            allowed.str(), found);
  }
  if (stop.length) {
    std::ostringstream allowed;
    allowed << "must be finite and above the length of the first two edges, " << start;
    require(std::isfinite(*stop.length) && *stop.length > start, "stop.length", *stop.length,
            allowed.str(), found);
  }
  if (stop.increments) {
    require(*stop.increments > 0, "stop.increments", static_cast<double>(*stop.increments),
            "must be at least 1", found);
  }
}

void check_dynamics(const Scenario& scenario, std::vector<std::string>& found) {
  const double density = scenario.density;
  check_positive("wire.density", density, found);
  require(!is_positive(density) || (density >= 1e-60 && density <= 1e60), "wire.density", density,
          "must be between 1e-60 and 1e60", found);
  const DynamicsOptions& dynamics = scenario.dynamics;
  if (dynamics.damping) {
    require(is_not_negative(*dynamics.damping), "dynamics.damping", *dynamics.damping,
            "must be finite and not negative", found);
  }
  if (dynamics.insertion_speed) {
    check_positive("dynamics.insertion_speed", *dynamics.insertion_speed, found);
  }
  if (dynamics.time_step) {
    std::ostringstream allowed;
    const double longest = longest_time_step(scenario);
    allowed << "must be positive and at most " << longest
            << ": vibrations grow by themselves when it is longer than half of the inverse of the "
               "highest frequency, and contacts that stick or damping may ask for less";
    require(is_positive(*dynamics.time_step) && *dynamics.time_step <= longest * (1 + round_off),
            "dynamics.time_step", *dynamics.time_step, allowed.str(), found);
  }
}

void check_minimizer(const MinimizerOptions& minimizer, std::vector<std::string>& found) {
  require(minimizer.tolerance >= 1e-10 && minimizer.tolerance <= 1, "minimizer.tolerance",
          minimizer.tolerance, "must be between 1e-10 and 1 (in units of YI / R^2)", found);
  require(minimizer.max_evaluations >= 1, "minimizer.max_evaluations", minimizer.max_evaluations,
          "must be at least 1", found);
  require(minimizer.memory >= 1 && minimizer.memory <= 1000, "minimizer.memory", minimizer.memory,
          "must be between 1 and 1000", found);
  // fewer would end a round within its first line search
  const bool compact = minimizer.method == DescentMethod::compact_lbfgs;
  require(minimizer.refactor_every >= (compact ? 5 : 2), "minimizer.refactor_every",
          minimizer.refactor_every,
          compact ? "must be at least 5 with minimizer.method = \"compact_lbfgs\""
                  : "must be at least 2",
          found);
  check_positive("minimizer.shift", minimizer.shift, found);
}

void check_imperfection(const Scenario& scenario, std::vector<std::string>& found) {
  const ImperfectionOptions& imperfection = scenario.imperfection;
  const auto up_to = [&](const char* key, double value, double largest, const char* unit) {
    std::ostringstream allowed;
    allowed << "must be between 0 and " << largest << " (" << unit << ")";
    require(is_not_negative(value) && value <= largest * (1 + round_off), key, value, allowed.str(),
            found);
  };
  up_to("imperfection.natural_curvature", imperfection.natural_curvature, 1, "over 1 / R");
  require(imperfection.natural_curvature == 0 || scenario.wire.reference_shape.empty(),
          "imperfection.natural_curvature", imperfection.natural_curvature,
          "must be 0 beside wire.reference_shape, which says all about the wire's rest shape",
          found);
  const auto& position = scenario.nozzle.position;
  const double reach = position && position->allFinite() ? position->norm()
                                                         : semi_axes_of(scenario.cavity).minCoeff();
  up_to("imperfection.nozzle_offset", imperfection.nozzle_offset,
        reach / (4 * scenario.wire.radius),
        position ? "wire radii, by the nozzle's distance from the centre" : "wire radii");
  up_to("imperfection.nozzle_tilt", imperfection.nozzle_tilt, 0.5, "rad");
}

void check_output(const OutputOptions& output, std::vector<std::string>& found) {
  check_positive("output.frame_every_density", output.frame_every_density, found);
  require(is_not_negative(output.checkpoint_every_seconds), "output.checkpoint_every_seconds",
          output.checkpoint_every_seconds, "must not be negative", found);
}

}  // namespace

std::vector<std::string> problems(const Scenario& scenario) {
  std::vector<std::string> found = problems(scenario.wire);
  check_reference_shape(scenario, found);
  for (const std::string& problem : cavity_problems(scenario)) found.push_back(problem);
  for (const std::string& problem : problems(scenario.friction)) found.push_back(problem);
  check_contacts(scenario, found);
  check_insertion(scenario, found);
  check_stop(scenario, found);
  check_dynamics(scenario, found);
  check_minimizer(scenario.minimizer, found);
  check_imperfection(scenario, found);
  check_output(scenario.output, found);
  check_nozzle(scenario, found);
  if (found.empty()) check_magnitudes(scenario, found);
  return found;
}

}  // namespace wirepack
