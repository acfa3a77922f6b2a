#include "wirepack/packing/dynamics_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wirepack/dynamics/stick_limit.hpp"

namespace wirepack {

namespace {

// Far below where vibrations grow by themselves (gear_values.hpp): at 0.35 the energies of a
// packing with friction miss by up to 1 % of the work, at 0.2 by 0.03 % (R = 5).
constexpr double auto_share = 0.2;

// At the step at which stick forces chatter, energies miss by 18 % of the work; at 0.6 of it by
// 3 %, at 0.4 by 0.1 % (R = 4, contacts of 16 Y, to phi = 0.3).
constexpr double auto_stick_share = 0.4, longest_stick_share = 0.6;

// Over the damping: beyond 0.163 (0.14 at the longest step for vibrations) the scheme is unstable,
// by the spectral radius of its step for x'' = -g x'.
constexpr double auto_damping_share = 0.1, longest_damping_share = 0.14;

constexpr double tangential_share = 2.0 / 3;
constexpr double tangential_damping_ratio = 0.05;

// Where the growth per step is 2e-4 without damping.
constexpr double longest_share = 0.5;

double mass_per_length(const Scenario& scenario) {
  return scenario.density * pi * scenario.wire.radius * scenario.wire.radius;
}

// Highest frequencies of the discrete wire. Bending: 16 B / (m l^3) for a node of mass m among
// equal edges; the joints next to the nozzle are stiffer, 39 for an inlet edge of l/2. Torsion,
// which contacts do not stiffen: 4 GJ / (I l^2), I the polar moment of inertia per length, and 11.1
// for that inlet edge. Contact: six neighbouring strands that move against each other, or the wall
// and five.
double highest_frequency_of(const Scenario& scenario) {
  const Stiffness stiff = stiffness(scenario.wire);
  const double a = scenario.wire.radius, l = scenario.wire.edge_length;
  const double mass = mass_per_length(scenario);
  const double axial = 4 * stiff.stretch / (mass * l * l);
  const double bending = 39 * stiff.bend / (mass * l * l * l * l);
  const double torsion = 11.1 * stiff.twist / (mass * a * a / 2 * l * l);
  const double strands = scenario.contact_enabled ? 6 * scenario.contact.stiffness : 0;
  // the tip is half an edge that touches the wall over 2 a
  const double tip = scenario.wall_stiffness * 4 * a / l;
  const double contact = std::max(scenario.wall_stiffness + strands, tip) / mass;
  return std::sqrt(std::max(std::max(axial, bending) + contact, torsion));
}

// Largest stiffness over mass, where a point that sticks is as stiff along the surface as across.
// The surface is a away from the axis, so it also slips as edges turn, by a / l of the moves of
// their nodes. The tip: a point contact of 2 a, on half an edge that stands upright on the wall.
// Crossing strands: such a contact in the middle of two edges, which move sideways and spin, or
// move along and turn.
double stick_stiffness_per_mass(const Scenario& scenario) {
  const double r = scenario.wire.radius / scenario.wire.edge_length;
  const double tip = 2 * r * scenario.wall_stiffness * (2 * (1 + r) * (1 + r) + r * r);
  const double strands = scenario.contact_enabled ? scenario.contact.stiffness : 0;
  const double crossing = 2 * r * strands * 2 * std::max(2.5, 0.5 + 2 * r * r);
  return std::max(tip, crossing) / mass_per_length(scenario);
}

double longest_step_of_sticking(const Scenario& scenario) {
  if (scenario.friction.model == FrictionModel::none)
    return std::numeric_limits<double>::infinity();
  return longest_stick_step(stick_slip_law(scenario), stick_stiffness_per_mass(scenario));
}

double sound_speed(const Scenario& scenario) {
  return std::sqrt(scenario.wire.youngs_modulus / scenario.density);
}

double damping_of(const Scenario& scenario) {
  const double radius = scenario.cavity.radius;
  return scenario.dynamics.damping.value_or(sound_speed(scenario) * scenario.wire.radius /
                                            (4 * radius * radius));
}

}  // namespace

StickSlipLaw stick_slip_law(const Scenario& scenario) {
  const double frequency =
      std::sqrt(tangential_share * scenario.contact.stiffness / mass_per_length(scenario));
  return {scenario.friction.static_coefficient, scenario.friction.dynamic_coefficient,
          tangential_share, 2 * tangential_damping_ratio / frequency};
}

DynamicsValues dynamics_values(const Scenario& scenario) {
  const double a = scenario.wire.radius, radius = scenario.cavity.radius;
  DynamicsValues values{};
  values.highest_frequency = highest_frequency_of(scenario);
  values.damping = damping_of(scenario);
  values.insertion_speed =
      scenario.dynamics.insertion_speed.value_or(sound_speed(scenario) * a / (40 * radius));
  values.time_step = scenario.dynamics.time_step.value_or(std::min(
      {auto_share / values.highest_frequency, auto_stick_share * longest_step_of_sticking(scenario),
       auto_damping_share / values.damping}));
  return values;
}

double longest_time_step(const Scenario& scenario) {
  return std::min({longest_share / highest_frequency_of(scenario),
                   longest_stick_share * longest_step_of_sticking(scenario),
                   longest_damping_share / damping_of(scenario)});
}

}  // namespace wirepack
