#include "wirepack/packing/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "wirepack/observe/loop_sizes.hpp"
#include "wirepack/observe/packing_density.hpp"

namespace wirepack {

namespace {

// Numbers that were converted from other units are off by this much.
constexpr double round_off = 1e-9;
constexpr double largest_overlap_meant = 0.3;  // wire radii
constexpr double fewest_frames = 5;
// Bends that are so far from the cavity's are in another unit of length.
constexpr double other_unit = 100;

template <class... Parts>
void add(std::vector<std::string>& found, const Parts&... parts) {
  std::ostringstream text;
  text.precision(4);
  (text << ... << parts);
  found.push_back(text.str());
}

double largest_at_rest(const RodParams& wire) {
  double largest = std::hypot(wire.rest_darboux.x(), wire.rest_darboux.y());
  for (const DarbouxRow& row : wire.reference_shape.table.rows()) {
    largest = std::max(largest, std::hypot(row.darboux.x(), row.darboux.y()));
  }
  return largest;
}

void check_rest_shape(const Scenario& scenario, std::vector<std::string>& found) {
  const double a = scenario.wire.radius, radius = scenario.cavity.radius;
  const double largest = largest_at_rest(scenario.wire);
  if (largest * a > 1 + round_off) {
    add(found, "at rest the wire bends to a radius of ", 1 / largest,
        ", tighter than its own, wire.radius = ", a);
  }
  const ReferenceShape& shape = scenario.wire.reference_shape;
  if (shape.empty() || largest == 0 || largest * radius * other_unit > 1) return;
  add(found, "wire.reference_shape bends to a radius of ", 1 / largest,
      " at most, cavity.radius is ", radius, ": are both in the same unit of length?");
}

// Nothing else in a run depends on Poisson's ratio.
void check_torsion(const Scenario& scenario, std::vector<std::string>& found) {
  constexpr double largest_of_solids = 0.5;
  if (scenario.wire.poisson_ratio <= largest_of_solids * (1 + round_off)) return;
  const Stiffness of_wire = stiffness(scenario.wire);
  add(found, "GJ = ", of_wire.twist, " is below two thirds of EI = ", of_wire.bend,
      ", as in no solid round wire: wire.poisson_ratio = ", scenario.wire.poisson_ratio,
      " is above 0.5");
}

void check_friction(const FrictionParams& friction, std::vector<std::string>& found) {
  const FrictionParams plain;
  if (friction.model != FrictionModel::none) return;
  if (friction.static_coefficient == plain.static_coefficient &&
      friction.dynamic_coefficient == plain.dynamic_coefficient &&
      friction.slip_tolerance == plain.slip_tolerance) {
    return;
  }
  add(found, "friction.model is none, so there is no friction: friction.static = ",
      friction.static_coefficient, " and the other keys of [friction] have no effect");
}

void check_mesh(const Scenario& scenario, std::vector<std::string>& found) {
  const double a = scenario.wire.radius, l = scenario.wire.edge_length;
  if (l > 2 * a * (1 + round_off)) {
    add(found, "wire.edge_length = ", l, " is longer than the wire is thick, ", 2 * a,
        ": contacts of strands are coarse");
  }
  if (l > scenario.cavity.radius / 5 * (1 + round_off)) {
    add(found, "wire.edge_length = ", l, " is longer than a fifth of cavity.radius, ",
        scenario.cavity.radius / 5, ": coils are polygons of few sides");
  }
}

}  // namespace

std::vector<std::string> warnings(const Scenario& scenario, double expected_length) {
  std::vector<std::string> found;
  check_rest_shape(scenario, found);
  check_torsion(scenario, found);
  check_friction(scenario.friction, found);
  check_mesh(scenario, found);
  const double density = packing_density(expected_length, scenario.cavity, scenario.wire.radius);
  const double frames = std::floor(density / scenario.output.frame_every_density) + 1;
  if (frames < fewest_frames) {
    add(found, "output.frame_every_density = ", scenario.output.frame_every_density,
        " saves fewer than ", fewest_frames, " frames up to the expected density of ", density);
  }
  return found;
}

std::vector<std::string> warnings(const Scenario& scenario, const PackingProgress& progress,
                                  double largest_overlap) {
  std::vector<std::string> found;
  const double overlap = largest_overlap / scenario.wire.radius;
  if (overlap > largest_overlap_meant) {
    add(found, "surfaces overlap by ", overlap, " a, more than the ", largest_overlap_meant,
        " a that contacts are meant for; stiffer ones (contact.stiffness, cavity.wall_stiffness) "
        "overlap less");
  }
  double curvature = 0;  // in units of the wire
  for (const double local : local_curvatures(progress.rod)) curvature = std::max(curvature, local);
  if (curvature > 1 + round_off) {
    add(found, "the wire ends bent to a radius of ", 1 / curvature, " a, tighter than its own");
  }
  return found;
}

}  // namespace wirepack
