#include "wirepack/core/error.hpp"
#include "wirepack/packing/quasistatic_packing.hpp"
#include "wirepack/verify/fed_elastica.hpp"

#include "problems.hpp"

namespace wirepack {

std::vector<KnownProblem> feeding_problems() {
  Scenario scenario = default_scenario(Setup::low_torsion, {40});
  scenario.wire.stretch_multiplier = 50;  // nearly inextensible
  scenario.wire.edge_length = 1;
  scenario.wall_stiffness = 500;  // the tip's reaction on half an edge shall not move the tip
  scenario.stop = {};
  scenario.stop.length = 110;  // before the second contact with the wall
  const double bend = stiffness(scenario.wire).bend;
  const double unit = force_unit(scenario);
  const FedElastica wire{scenario.cavity.radius - scenario.wire.radius, bend};

  double before_contact = 0;
  std::vector<KnownProblem> found;
  FedElastica::Shape exact = wire.first_bent(0.05);
  QuasistaticPacking packing(scenario);
  for (bool going = true; going;) {
    const auto stop = packing.advance().stop;
    if (stop && *stop != StopReason::length) throw NumericalFailure("the wire was not fed");
    going = !stop;
    const HistoryRow& row = packing.progress().last;
    const double length = row.inserted_length;
    if (length < 2 * wire.rho - 1e-9) before_contact = std::max(before_contact, row.scaled_force);
    const bool compared = length >= 80 && found.size() < static_cast<std::size_t>(length / 10 - 7);
    if (!compared) continue;
    exact = wire.at_length(length, exact);
    const std::string where = "wire fed into a sphere, L = " + std::to_string(std::lround(length));
    found.push_back(
        {where + ": F R^2 / YI", exact.force / unit, row.scaled_force, 0.005, "l = R / 40"});
  }
  const HistoryRow& last = packing.progress().last;
  found.push_back({"the same: energy R / YI", exact.energy * 40 / bend,
                   last.energy_total * 40 / bend, 0.005, "l = R / 40"});
  found.push_back({"the same: int F dL / energy", 1,
                   packing.progress().balance.work / last.energy_total, 0.005,
                   "sum over increments of a / 2"});
  found.push_back({"the same: F R^2 / YI before contact", 0, before_contact, 1e-3,
                   "ten times the minimizer's tolerance"});
  return found;
}

}  // namespace wirepack
