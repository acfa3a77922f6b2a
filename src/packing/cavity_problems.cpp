#include "cavity_problems.hpp"

#include <cmath>
#include <sstream>

#include "wirepack/core/value_problems.hpp"

#include "scenario_numbers.hpp"

namespace wirepack {

namespace {

// `half` is half of the room for a wire's centreline, across the cavity where it is narrowest.
void check_edge_length(const Scenario& scenario, double half, const std::string& room,
                       std::vector<std::string>& found) {
  const double l = scenario.wire.edge_length, a = scenario.wire.radius;
  if (!is_positive(l)) return;
  std::ostringstream text;
  if (l > half * (1 + round_off)) {
    text << "wire.edge_length = " << l << ": must be at most half of " << room << ", " << half;
    found.push_back(text.str());
  } else if (l < a / 10 * (1 - round_off)) {
    text << "wire.edge_length = " << l << ": must be at least a tenth of wire.radius = " << a;
    found.push_back(text.str());
  }
}

void check_sphere(const Scenario& scenario, std::vector<std::string>& found) {
  const double a = scenario.wire.radius, radius = scenario.cavity.radius;
  std::ostringstream text;
  text << "cavity.radius = " << radius << ": must be ";
  if (!is_positive(radius)) {
    text << "positive and finite";
    found.push_back(text.str());
  } else if (!is_positive(a)) {
    return;
  } else if (radius < 2 * a * (1 - round_off)) {
    text << "at least twice wire.radius = " << a;
    if (radius < a / 10) text << "; are both in the same unit of length?";
    found.push_back(text.str());
  } else {
    if (radius > 1000 * a * (1 + round_off)) {
      text << "at most 1000 times wire.radius = " << a;
      if (radius > 1e5 * a) text << "; are both in the same unit of length?";
      found.push_back(text.str());
    }
    check_edge_length(scenario, (radius - a) / 2, "cavity.radius - wire.radius", found);
  }
}

void check_ellipsoid(const Scenario& scenario, std::vector<std::string>& found) {
  const double a = scenario.wire.radius;
  const Vec3& axes = *scenario.cavity.semi_axes;
  std::ostringstream text;
  text << "cavity.semi_axes = [" << axes.x() << ", " << axes.y() << ", " << axes.z() << "]: must ";
  if (!(is_positive(axes.x()) && is_positive(axes.y()) && is_positive(axes.z()))) {
    text << "be positive and finite";
    found.push_back(text.str());
  } else if (!is_positive(a)) {
    return;
  } else if (smallest_wall_radius(scenario.cavity) < 2 * a * (1 - round_off)) {
    text << "bend the wall to no less than twice wire.radius = " << a
         << "; shortest^2 / longest is " << smallest_wall_radius(scenario.cavity);
    found.push_back(text.str());
  } else if (axes.maxCoeff() > 1000 * a * (1 + round_off)) {
    text << "be at most 1000 times wire.radius = " << a;
    found.push_back(text.str());
  } else if (std::abs(std::cbrt(axes.prod()) / scenario.cavity.radius - 1) > round_off) {
    found.push_back("cavity.radius: must be that of the sphere of the ellipsoid's volume");
  } else {
    check_edge_length(scenario, (axes.minCoeff() - a) / 2,
                      "the shortest of cavity.semi_axes - wire.radius", found);
  }
}

}  // namespace

std::vector<std::string> cavity_problems(const Scenario& scenario) {
  std::vector<std::string> found;
  scenario.cavity.semi_axes ? check_ellipsoid(scenario, found) : check_sphere(scenario, found);
  return found;
}

}  // namespace wirepack
