#include "wirepack/packing/own_units.hpp"

#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "scenario_numbers.hpp"

namespace wirepack {

namespace {

// To 13 digits.
double rounded(double number) {
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), number,
                                     std::chars_format::scientific, 12);
  std::from_chars(text.data(), written.ptr, number);
  return number;
}

double unit_of(const HistoryColumn& column, const Units& units) {
  if (column.unit == "length") return units.length;
  if (column.unit == "force") return units.force();
  if (column.unit == "force length") return units.energy();
  if (column.unit == "time") return units.time();
  return 1;
}

template <class F>
void for_each_energy(WorkBalance& balance, F&& f) {
  f(balance.work);
  f(balance.released);
  f(balance.remeshing);
  f(balance.friction);
  f(balance.contact_springs);
  f(balance.viscous);
}

void divide(MotionProgress& motion, const Units& units) {
  motion.nodes /= units.length;  // derivatives come times powers of the time step
  motion.time /= units.time();
  motion.step /= units.time();
  for (std::vector<StickAnchor>* anchors : {&motion.friction.strands, &motion.friction.wall}) {
    for (StickAnchor& anchor : *anchors) {
      anchor.spring /= units.length;
      anchor.normal_force /= units.force();
    }
  }
  EnergyFlow& flow = motion.flow;
  for (double* energy : {&flow.potential, &flow.kinetic, &flow.stick}) *energy /= units.energy();
  for (double* power : {&flow.feed, &flow.friction, &flow.viscous, &flow.medium}) {
    *power /= units.power();
  }
  flow.injection_force /= units.force();
}

}  // namespace

Scenario in_own_units(const Scenario& scenario) {
  Scenario own = scenario;
  for_each_number_with_unit(
      own, [](const char*, double& number, double unit) { number = rounded(number / unit); });
  if (!scenario.wire.reference_shape.empty()) {
    const double a = scenario.wire.radius;
    std::vector<DarbouxRow> rows = scenario.wire.reference_shape.table.rows();
    for (DarbouxRow& row : rows) {
      row.arc = rounded(row.arc / a);
      for (double& k : row.darboux) k = rounded(k * a);
    }
    own.wire.reference_shape.table = DarbouxTable(std::move(rows));
  }
  return own;
}

PackingProgress in_own_units(PackingProgress progress, const Units& units) {
  progress.rod.nodes /= units.length;
  progress.rod.inlet_rest_length /= units.length;
  for (const HistoryColumn& column : history_columns) {
    progress.last.*column.value /= unit_of(column, units);
  }
  for_each_energy(progress.balance, [&](double& energy) { energy /= units.energy(); });
  progress.work_errors.trapezoid /= units.energy();
  for (SlipMemory& memory : progress.slip_memory) {
    memory.spring /= units.length;
    memory.slid /= units.length;
  }
  for (ForceReading& reading : progress.recent_forces) {
    reading.inserted_length /= units.length;
    reading.force /= units.force();
  }
  if (progress.motion) divide(*progress.motion, units);
  return progress;
}

HistoryRow in_units(HistoryRow row, const Units& units) {
  for (const HistoryColumn& column : history_columns) {
    row.*column.value *= unit_of(column, units);
  }
  return row;
}

WorkBalance in_units(const WorkBalance& balance, const Units& units) {
  WorkBalance result = balance;
  for_each_energy(result, [&](double& energy) { energy *= units.energy(); });
  return result;
}

PackingFrame in_units(PackingFrame frame, const Units& units) {
  frame.rod.nodes *= units.length;
  frame.rod.inlet_rest_length *= units.length;
  frame.inserted_length *= units.length;
  frame.force *= units.force();
  frame.bend_energy *= units.energy();
  frame.twist_energy *= units.energy();
  frame.wall_force *= units.force();
  for (SelfContact& contact : frame.contacts) {
    contact.line.stiffness *= units.force() / units.length;
    contact.line.separation *= units.length;
    contact.line.distance *= units.length;
    contact.overlap *= units.length;
    contact.force *= units.force();
  }
  return frame;
}

}  // namespace wirepack
