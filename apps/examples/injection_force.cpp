#include <cstdio>

#include <wirepack/packing/packing_run.hpp>

int main() {
  wirepack::Scenario scenario = wirepack::default_scenario(wirepack::Setup::low_torsion, {10});
  scenario.stop.density = 0.1;
  wirepack::PackingRun packing(scenario);
  while (!packing.advance()) {
    const wirepack::HistoryRow row = packing.row();
    std::printf("%8.4f %10.3e\n", row.packing_density, row.scaled_force);
  }
}
