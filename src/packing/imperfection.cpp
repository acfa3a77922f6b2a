#include "wirepack/packing/imperfection.hpp"

#include <cmath>

#include "wirepack/core/random.hpp"
#include "wirepack/core/rotation.hpp"

namespace wirepack {

namespace {

// Across the third axis: in a random direction, uniform in length up to 1.
Vec3 sideways(Random& random) {
  const double angle = pi * random.symmetric();
  const double length = random.symmetric();
  return length * Vec3(std::cos(angle), std::sin(angle), 0);
}

Vec3 turned_by(const Vec3& rotation, const Vec3& v) {
  const double angle = rotation.norm();
  return angle > 0 ? rotation_about(rotation / angle, angle) * v : v;
}

}  // namespace

DrawnSetup drawn_setup(const Scenario& scenario) {
  const ImperfectionOptions& amplitude = scenario.imperfection;
  DrawnSetup setup{scenario.wire,
                   polar_nozzle(scenario.cavity, scenario.wire.radius, scenario.nozzle_twist)};
  // not the numbers of the perturbations, which start with the seed itself
  Random random(~scenario.seed);
  const Vec3 curvature = sideways(random), offset = sideways(random), tilt = sideways(random);
  setup.wire.rest_darboux += amplitude.natural_curvature / scenario.cavity.radius * curvature;
  Nozzle& nozzle = setup.nozzle;
  const double reach = nozzle.position.norm();
  nozzle.position =
      turned_by(amplitude.nozzle_offset * scenario.wire.radius / reach * offset, nozzle.position);
  if (scenario.cavity.semi_axes) {
    nozzle.position = touching_point(scenario.cavity, nozzle.position, scenario.wire.radius);
  }
  nozzle.direction = turned_by(amplitude.nozzle_tilt * tilt, nozzle.direction);
  return setup;
}

}  // namespace wirepack
