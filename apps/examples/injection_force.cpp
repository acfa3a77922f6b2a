#include <cstdio>

#include <wirepack/packing/packing_run.hpp>

int main() {
  wirepack::Scenario scenario = wirepack::default_scenario(wirepack::Setup::low_torsion, {10});
  scenario.stop.density = 0.1;
  wirepack::PackingRun packing(scenario);
  for (wirepack::Advance step; !step.stop;) {
    step = packing.advance();
    if (step.row) std::printf("%8.4f %10.3e\n", step.row->packing_density, step.row->scaled_force);
  }
}
