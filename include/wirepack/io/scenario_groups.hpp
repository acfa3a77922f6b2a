#pragma once

#include <cstddef>
#include <vector>

#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// Places in a list of scenarios, those of a group in the order of the list, groups in the order of
/// their first.
using ScenarioGroups = std::vector<std::vector<std::size_t>>;

/// Scenarios that differ in their seeds alone: means and errors are taken over them. The same seed
/// once more is no independent run and starts a group of its own.
ScenarioGroups seed_groups(const std::vector<Scenario>& scenarios);

/// Scenarios of one setup, method, wire and friction, in cavities of any radius: a law of a / R may
/// be fitted to them. Seeds, meshes, increments, tolerances, limits, the offset of the nozzle, and
/// units may differ. So may the stiffness of contacts, if each radius has one; where a radius has
/// two, each stiffness is a series.
ScenarioGroups radius_series(const std::vector<Scenario>& scenarios);

}  // namespace wirepack
