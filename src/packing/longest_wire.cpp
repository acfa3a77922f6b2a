#include "wirepack/packing/longest_wire.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wirepack/observe/packing_density.hpp"

namespace wirepack {

double longest_wire(const Scenario& scenario) {
  const StopLimits& stop = scenario.stop;
  double length = std::numeric_limits<double>::infinity();
  if (stop.length) length = *stop.length;
  if (stop.density) {
    length =
        std::min(length, length_at_density(*stop.density, scenario.cavity, scenario.wire.radius));
  }
  if (stop.increments) {
    length =
        std::min(length, 2 * scenario.wire.edge_length +
                             static_cast<double>(*stop.increments) * scenario.insertion.increment);
  }
  return length;
}

double expected_length(const Scenario& scenario) {
  const StopLimits& stop = scenario.stop;
  double length = longest_wire(scenario);
  if (stop.scaled_force || stop.force) {
    const double density = 0.98 * std::pow(scenario.wire.radius / scenario.cavity.radius, 0.38);
    length = std::min(length, length_at_density(density, scenario.cavity, scenario.wire.radius));
  }
  return length;
}

}  // namespace wirepack
