#include "wirepack/io/scenario_groups.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>
#include <string>

#include "wirepack/io/config_file.hpp"
#include "wirepack/packing/own_units.hpp"

namespace wirepack {

namespace {

std::string but_for_the_seed(Scenario scenario) {
  scenario.seed = 0;
  return resolved_config(scenario);
}

double rounded(double number) { return std::round(number * 1e9) / 1e9; }

// The physics of a scenario in a cavity of R = 10 a, whatever the stiffness of contacts.
std::string in_one_cavity(const Scenario& scenario) {
  constexpr double radius = 10;
  const Scenario own = in_own_units(scenario);
  Scenario same = default_scenario(own.setup, {radius}, 1, 1, own.method);
  same.wire.poisson_ratio = own.wire.poisson_ratio;
  same.wire.stretch_multiplier = own.wire.stretch_multiplier;
  // rest curvatures belong to the cavity, as 1 / (2 R) does
  for (Eigen::Index k = 0; k < 3; ++k) {
    same.wire.rest_darboux[k] = rounded(own.wire.rest_darboux[k] * own.cavity.radius) / radius;
  }
  same.wire.reference_shape = own.wire.reference_shape;
  same.nozzle = own.nozzle;
  // a nozzle at the wall is as far from the centre as the wire's axis gets
  const double to_one = (radius - 1) / (own.cavity.radius - 1);
  if (same.nozzle.position)
    *same.nozzle.position = (to_one * *own.nozzle.position).unaryExpr(&rounded);
  same.nozzle.depth = rounded(to_one * own.nozzle.depth);
  same.contact_enabled = own.contact_enabled;
  same.friction = own.friction;
  same.dynamics = own.dynamics;
  same.imperfection.natural_curvature = own.imperfection.natural_curvature;
  same.imperfection.nozzle_tilt = own.imperfection.nozzle_tilt;
  return but_for_the_seed(same);
}

ScenarioGroups equal_places(const std::vector<std::string>& names) {
  ScenarioGroups groups;
  std::map<std::string, std::size_t> group_of;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto [known, is_new] = group_of.emplace(names[k], groups.size());
    if (is_new) groups.emplace_back();
    groups[known->second].push_back(k);
  }
  return groups;
}

// A stiffness for each radius is a choice of method, as a mesh is. Two of them at one radius are
// a comparison: then each stiffness is a series.
ScenarioGroups by_stiffness_of_contacts(const std::vector<Scenario>& scenarios,
                                        const std::vector<std::size_t>& members) {
  std::vector<std::string> stiffnesses;
  std::map<double, std::set<std::string>> at_radius;
  bool is_comparison = false;
  for (const std::size_t k : members) {
    const Scenario own = in_own_units(scenarios[k]);
    stiffnesses.push_back(fmt::format("{:.9g} {:.9g}", own.contact.stiffness, own.wall_stiffness));
    std::set<std::string>& same = at_radius[rounded(own.cavity.radius)];
    same.insert(stiffnesses.back());
    is_comparison = is_comparison || same.size() > 1;
  }
  if (!is_comparison) return {members};
  ScenarioGroups parts = equal_places(stiffnesses);
  for (std::vector<std::size_t>& part : parts) {
    for (std::size_t& place : part) place = members[place];
  }
  return parts;
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
  std::vector<std::string> physics;
  for (const Scenario& scenario : scenarios) physics.push_back(in_one_cavity(scenario));
  ScenarioGroups series;
  for (const std::vector<std::size_t>& members : equal_places(physics)) {
    for (std::vector<std::size_t>& part : by_stiffness_of_contacts(scenarios, members)) {
      series.push_back(std::move(part));
    }
  }
  std::sort(series.begin(), series.end(),
            [](const auto& one, const auto& other) { return one.front() < other.front(); });
  return series;
}

}  // namespace wirepack
