#include "wirepack/packing/longest_wire.hpp"

#include <algorithm>
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

}  // namespace wirepack
