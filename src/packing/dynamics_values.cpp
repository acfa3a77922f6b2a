#include "wirepack/packing/dynamics_values.hpp"

#include <algorithm>
#include <cmath>

namespace wirepack {

namespace {

// Far below where vibrations grow by themselves (gear_values.hpp): at 0.35 the energies of a
// packing with friction miss by up to 1 % of the work, at 0.2 by 0.03 % (R = 5).
constexpr double auto_share = 0.2;

// Where the growth per step is 2e-4 without damping.
constexpr double longest_share = 0.5;

// Highest frequencies of the discrete wire. Bending: 16 B / (m l^3) for a node of mass m among
// equal edges; the joints next to the nozzle are stiffer, 39 for an inlet edge of l/2. Contact: six
// neighbouring strands that move against each other, or the wall and five.
double highest_frequency_of(const Scenario& scenario) {
  const Stiffness stiff = stiffness(scenario.wire);
  const double a = scenario.wire.radius, l = scenario.wire.edge_length;
  const double mass_per_length = scenario.density * pi * a * a;
  const double axial = 4 * stiff.stretch / (mass_per_length * l * l);
  const double bending = 39 * stiff.bend / (mass_per_length * l * l * l * l);
  const double strands = scenario.contact_enabled ? 6 * scenario.contact.stiffness : 0;
  // the tip is half an edge that touches the wall over 2 a
  const double tip = scenario.wall_stiffness * 4 * a / l;
  const double contact = std::max(scenario.wall_stiffness + strands, tip) / mass_per_length;
  return std::sqrt(std::max(axial, bending) + contact);
}

}  // namespace

DynamicsValues dynamics_values(const Scenario& scenario) {
  const double a = scenario.wire.radius, radius = scenario.cavity.radius;
  const double sound = std::sqrt(scenario.wire.youngs_modulus / scenario.density);
  DynamicsValues values{};
  values.highest_frequency = highest_frequency_of(scenario);
  values.damping = scenario.dynamics.damping.value_or(sound * a / (4 * radius * radius));
  values.insertion_speed = scenario.dynamics.insertion_speed.value_or(sound * a / (40 * radius));
  values.time_step = scenario.dynamics.time_step.value_or(auto_share / values.highest_frequency);
  return values;
}

double longest_time_step(const Scenario& scenario) {
  return longest_share / highest_frequency_of(scenario);
}

}  // namespace wirepack
