#include "wirepack/packing/scenario.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

#include "wirepack/core/error.hpp"
#include "wirepack/observe/packing_density.hpp"
#include "wirepack/packing/dynamics_values.hpp"
#include "wirepack/packing/longest_wire.hpp"

#include "cavity_problems.hpp"
#include "nozzle_problems.hpp"
#include "scenario_numbers.hpp"

namespace wirepack {

Scenario default_scenario(Setup setup, const Cavity& cavity, double wire_radius,
                          double youngs_modulus, Method method) {
  Scenario scenario;
  scenario.setup = setup;
  scenario.method = method;
  const bool rubs = method == Method::dynamic;
  if (rubs) scenario.friction.model = FrictionModel::coulomb;
  scenario.cavity = cavity;
  scenario.wire.radius = wire_radius;
  scenario.wire.youngs_modulus = youngs_modulus;
  scenario.wire.edge_length = std::clamp(cavity.radius / 10, wire_radius / 2, 2 * wire_radius);
  if (setup == Setup::high_torsion) {
    scenario.nozzle.twist = TwistCondition::locked;
    scenario.wire.rest_darboux = Vec3(0, 1 / (2 * cavity.radius), 0);
    scenario.wire.edge_length = std::clamp(cavity.radius / 20, wire_radius / 2, 2 * wire_radius);
  }
  scenario.wall_stiffness = youngs_modulus;
  scenario.contact.stiffness = youngs_modulus;
  scenario.contact.excluded_arc_length = pi * wire_radius;
  scenario.insertion.increment = scenario.wire.edge_length / 2;
  scenario.stop.scaled_force = rubs ? 30 : 10;
  return scenario;
}

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
  double sharpest = 0;
  for (const DarbouxRow& row : shape.table.rows()) {
    sharpest = std::max(sharpest, row.darboux.norm());
  }
  std::ostringstream text;
  if (!(scenario.wire.edge_length * sharpest <= 1 + round_off)) {
    text << "wire.edge_length = " << scenario.wire.edge_length << ": must be at most "
         << 1 / sharpest << ", as wire.reference_shape turns by a radian over that";
    if (sharpest * scenario.wire.radius > 1) {
      text << "; it bends to a radius of " << 1 / sharpest << ", the wire's own radius is "
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

}  // namespace

std::vector<std::string> problems(const Scenario& scenario) {
  std::vector<std::string> found = problems(scenario.wire);
  check_reference_shape(scenario, found);
  for (const std::string& problem : cavity_problems(scenario)) found.push_back(problem);
  for (const std::string& problem : problems(scenario.friction)) found.push_back(problem);
  const auto require = [&](bool ok, const char* key, double value, const std::string& allowed) {
    if (ok) return;
    std::ostringstream text;
    text << key << " = " << value << ": " << allowed;
    found.push_back(text.str());
  };
  const auto positive = [](double v) { return std::isfinite(v) && v > 0; };
  const auto not_negative = [](double v) { return std::isfinite(v) && v >= 0; };
  const std::string must_be_positive = "must be positive and finite";
  const double a = scenario.wire.radius;
  const double l = scenario.wire.edge_length;
  require(positive(scenario.wall_stiffness), "cavity.wall_stiffness", scenario.wall_stiffness,
          must_be_positive);
  require(positive(scenario.contact.stiffness), "contact.stiffness", scenario.contact.stiffness,
          must_be_positive);
  require(positive(scenario.contact.excluded_arc_length), "contact.excluded_arc_length",
          scenario.contact.excluded_arc_length, must_be_positive);
  require(scenario.insertion.increment >= l / 1000 * (1 - round_off) &&
              scenario.insertion.increment <= l * (1 + round_off),
          "insertion.increment", scenario.insertion.increment,
          "must be at least a thousandth of wire.edge_length and at most all of it");
  require(scenario.insertion.perturbation >= 1e-9 && scenario.insertion.perturbation <= 0.1,
          "insertion.perturbation", scenario.insertion.perturbation,
          "must be between 1e-9 and 0.1 (wire radii): without one the wire does not buckle");

  const StopLimits& stop = scenario.stop;
  if (!stop.scaled_force && !stop.force && !stop.density && !stop.length && !stop.increments) {
    found.emplace_back(
        "stop = {}: needs at least one of scaled_force, force, density, length, increments");
  }
  if (stop.scaled_force) {
    require(positive(*stop.scaled_force), "stop.scaled_force", *stop.scaled_force,
            must_be_positive);
  }
  if (stop.force) require(positive(*stop.force), "stop.force", *stop.force, must_be_positive);
  // a run starts with two edges in the cavity
  const double start = 2 * l;
  const double start_density = packing_density(start, scenario.cavity, a);
  if (stop.density) {
    std::ostringstream allowed;
    allowed << "must be below 1 and above the density of the first two edges, " << start_density;
    require(*stop.density > start_density && *stop.density < 1, "stop.density", *stop.density,
            allowed.str());
  }
  if (stop.length) {
    std::ostringstream allowed;
    allowed << "must be finite and above the length of the first two edges, " << start;
    require(std::isfinite(*stop.length) && *stop.length > start, "stop.length", *stop.length,
            allowed.str());
  }
  if (stop.increments) {
    require(*stop.increments > 0, "stop.increments", static_cast<double>(*stop.increments),
            "must be at least 1");
  }

  require(positive(scenario.density), "wire.density", scenario.density, must_be_positive);
  require(!positive(scenario.density) || (scenario.density >= 1e-60 && scenario.density <= 1e60),
          "wire.density", scenario.density, "must be between 1e-60 and 1e60");
  if (scenario.dynamics.damping) {
    require(not_negative(*scenario.dynamics.damping), "dynamics.damping",
            *scenario.dynamics.damping, "must be finite and not negative");
  }
  if (scenario.dynamics.insertion_speed) {
    require(positive(*scenario.dynamics.insertion_speed), "dynamics.insertion_speed",
            *scenario.dynamics.insertion_speed, must_be_positive);
  }
  if (scenario.dynamics.time_step) {
    std::ostringstream allowed;
    const double longest = longest_time_step(scenario);
    allowed << "must be positive and at most " << longest
            << ": vibrations grow by themselves when it is longer than half of the inverse of the "
               "highest frequency, and contacts that stick may ask for less";
    require(positive(*scenario.dynamics.time_step) &&
                *scenario.dynamics.time_step <= longest * (1 + round_off),
            "dynamics.time_step", *scenario.dynamics.time_step, allowed.str());
  }

  const MinimizerOptions& m = scenario.minimizer;
  require(m.tolerance >= 1e-10 && m.tolerance <= 1, "minimizer.tolerance", m.tolerance,
          "must be between 1e-10 and 1 (in units of YI / R^2)");
  require(m.max_evaluations >= 1, "minimizer.max_evaluations", m.max_evaluations,
          "must be at least 1");
  require(m.memory >= 1 && m.memory <= 1000, "minimizer.memory", m.memory,
          "must be between 1 and 1000");
  // fewer would end a round within its first line search
  const bool compact = m.method == DescentMethod::compact_lbfgs;
  require(m.refactor_every >= (compact ? 5 : 2), "minimizer.refactor_every", m.refactor_every,
          compact ? "must be at least 5 with minimizer.method = \"compact_lbfgs\""
                  : "must be at least 2");
  require(positive(m.shift), "minimizer.shift", m.shift, must_be_positive);
  const ImperfectionOptions& imperfection = scenario.imperfection;
  const auto up_to = [&](const char* key, double value, double largest, const char* unit) {
    std::ostringstream allowed;
    allowed << "must be between 0 and " << largest << " (" << unit << ")";
    require(not_negative(value) && value <= largest * (1 + round_off), key, value, allowed.str());
  };
  up_to("imperfection.natural_curvature", imperfection.natural_curvature, 1, "over 1 / R");
  require(imperfection.natural_curvature == 0 || scenario.wire.reference_shape.empty(),
          "imperfection.natural_curvature", imperfection.natural_curvature,
          "must be 0 beside wire.reference_shape, which says all about the wire's rest shape");
  const double nozzle_reach = scenario.nozzle.position ? scenario.nozzle.position->norm()
                                                       : semi_axes_of(scenario.cavity).minCoeff();
  up_to("imperfection.nozzle_offset", imperfection.nozzle_offset, nozzle_reach / (4 * a),
        scenario.nozzle.position ? "wire radii, by the nozzle's distance from the centre"
                                 : "wire radii");
  up_to("imperfection.nozzle_tilt", imperfection.nozzle_tilt, 0.5, "rad");
  require(positive(scenario.output.frame_every_density), "output.frame_every_density",
          scenario.output.frame_every_density, must_be_positive);
  require(not_negative(scenario.output.checkpoint_every_seconds), "output.checkpoint_every_seconds",
          scenario.output.checkpoint_every_seconds, "must not be negative");
  check_nozzle(scenario, found);
  if (found.empty()) check_magnitudes(scenario, found);
  return found;
}

void require_valid(const Scenario& scenario) {
  std::string text;
  for (const std::string& problem : problems(scenario)) {
    text += (text.empty() ? "" : "\n") + problem;
  }
  if (!text.empty()) throw InvalidInput(text);
}

}  // namespace wirepack
