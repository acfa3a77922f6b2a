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

// At the same share of the way from the centre to the wall; `offset`, in wire radii, is across the
// third axis.
Vec3 moved_along_wall(const Scenario& scenario, const Vec3& position, const Vec3& offset) {
  const double a = scenario.wire.radius, distance = position.norm();
  if (distance == 0) return position;  // problems() allows no offset of the centre
  const Vec3 sideways = frame_with_tangent(position / distance) * offset;
  const Vec3 moved = turned_by(a / distance * sideways, position);
  if (!scenario.cavity.semi_axes) return moved;
  const Vec3 at_wall = touching_point(scenario.cavity, moved, a);
  if (!scenario.nozzle.position) return at_wall;
  return distance / touching_point(scenario.cavity, position, a).norm() * at_wall;
}

}  // namespace

DrawnSetup drawn_setup(const Scenario& scenario) {
  const ImperfectionOptions& amplitude = scenario.imperfection;
  DrawnSetup setup{scenario.wire,
                   nozzle_at_wall(scenario.nozzle, scenario.cavity, scenario.wire.radius)};
  // not the numbers of the perturbations, which start with the seed itself
  Random random(~scenario.seed);
  const Vec3 curvature = sideways(random), offset = sideways(random), tilt = sideways(random);
  setup.wire.rest_darboux += amplitude.natural_curvature / scenario.cavity.radius * curvature;
  Nozzle& nozzle = setup.nozzle;
  nozzle.position = moved_along_wall(scenario, nozzle.position, amplitude.nozzle_offset * offset);
  nozzle.direction = turned_by(
      amplitude.nozzle_tilt * (frame_with_tangent(nozzle.direction) * tilt), nozzle.direction);
  nozzle.position -= scenario.nozzle.depth * nozzle.direction;
  return setup;
}

}  // namespace wirepack
