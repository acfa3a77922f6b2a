#pragma once

#include "wirepack/feed/nozzle.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// The wire and the nozzle as the seed of a scenario makes them.
struct DrawnSetup {
  RodParams wire;
  Nozzle nozzle;
};

/// Adds to the scenario's wire a rest curvature, the same all along, and to its nozzle an offset
/// along the wall and a tilt, each in a random direction and uniform in size up to its amplitude.
/// Amplitudes of 0 leave everything as it is. A seed draws the same whatever the other values.
DrawnSetup drawn_setup(const Scenario& scenario);

}  // namespace wirepack
