#include "wirepack/io/scenario_groups.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "wirepack/io/config_file.hpp"
#include "wirepack/packing/own_units.hpp"

namespace wirepack {

namespace {

std::string but_for_the_seed(Scenario scenario) {
  scenario.seed = 0;
  return resolved_config(scenario);
}

// The physics of a scenario in a cavity of R = 10 a.
std::string in_one_cavity(const Scenario& scenario) {
  constexpr double radius = 10;
  const Scenario own = in_own_units(scenario);
  Scenario same = default_scenario(own.setup, {radius}, 1, 1, own.method);
  same.wire.poisson_ratio = own.wire.poisson_ratio;
  same.wire.stretch_multiplier = own.wire.stretch_multiplier;
  const auto rounded = [](double number) { return std::round(number * 1e9) / 1e9; };
  // rest curvatures belong to the cavity, as 1 / (2 R) does
  for (Eigen::Index k = 0; k < 3; ++k) {
    same.wire.rest_darboux[k] = rounded(own.wire.rest_darboux[k] * own.cavity.radius) / radius;
  }
  same.wire.reference_shape = own.wire.reference_shape;
  same.nozzle = own.nozzle;
  // a nozzle at the wall is as far from the centre as the wire's axis gets
  const double to_one = (radius - 1) / (own.cavity.radius - 1);
  if (same.nozzle.position)
    *same.nozzle.position = (to_one * *own.nozzle.position).unaryExpr(rounded);
  same.nozzle.depth = rounded(to_one * own.nozzle.depth);
  same.contact_enabled = own.contact_enabled;
  same.contact.stiffness = own.contact.stiffness;
  same.wall_stiffness = own.wall_stiffness;
  same.friction = own.friction;
  same.dynamics = own.dynamics;
  same.imperfection.natural_curvature = own.imperfection.natural_curvature;
  same.imperfection.nozzle_tilt = own.imperfection.nozzle_tilt;
  return but_for_the_seed(same);
}

}  // namespace

ScenarioGroups seed_groups(const std::vector<Scenario>& scenarios) {
  ScenarioGroups groups;
  std::vector<std::string> common;
  for (std::size_t k = 0; k < scenarios.size(); ++k) {
    const std::string of_this = but_for_the_seed(scenarios[k]);
    const auto has_room = [&](std::size_t group) {
      return common[group] == of_this &&
             std::none_of(groups[group].begin(), groups[group].end(), [&](std::size_t member) {
               return scenarios[member].seed == scenarios[k].seed;
             });
    };
    std::size_t group = 0;
    while (group < groups.size() && !has_room(group)) ++group;
    if (group == groups.size()) {
      common.push_back(of_this);
      groups.emplace_back();
    }
    groups[group].push_back(k);
  }
  return groups;
}

ScenarioGroups radius_series(const std::vector<Scenario>& scenarios) {
  ScenarioGroups series;
  std::vector<std::string> common;
  for (std::size_t k = 0; k < scenarios.size(); ++k) {
    const std::string of_this = in_one_cavity(scenarios[k]);
    const auto known = std::find(common.begin(), common.end(), of_this);
    const auto place = static_cast<std::size_t>(known - common.begin());
    if (known == common.end()) {
      common.push_back(of_this);
      series.emplace_back();
    }
    series[place].push_back(k);
  }
  return series;
}

}  // namespace wirepack
