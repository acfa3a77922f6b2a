// Packs a wire and keeps a result file: pack_a_wire OUT.h5
#include <cstdio>
#include <optional>
#include <string>

#include <wirepack/core/error.hpp>
#include <wirepack/io/hdf5_recorder.hpp>
#include <wirepack/packing/packing_run.hpp>

namespace {

using namespace wirepack;

bool is_failure(std::optional<StopReason> stop) {
  return stop == StopReason::no_equilibrium || stop == StopReason::strands_passed;
}

StopReason pack(const Scenario& scenario, const std::string& file) {
  PackingRun packing(scenario);
  Hdf5Recorder recorder(file, scenario, "pack_a_wire " + file);
  std::optional<StopReason> stop;
  while (!stop) {
    stop = packing.advance();
    // After a failure the progress is still that of the last good increment, which has its row.
    if (!is_failure(stop)) recorder.add(packing.row());
    if (stop || packing.frame_is_due()) recorder.add(packing.take_frame());
  }
  recorder.flush(packing.progress(), stop);
  const HistoryRow last = packing.row();
  std::printf("phi = %.4f, F R^2/YI = %.4f, %.0f contacts\n", last.packing_density,
              last.scaled_force, last.contacts);
  return *stop;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: pack_a_wire OUT.h5\n", stderr);
    return 2;
  }
  try {
    Scenario scenario = default_scenario(Setup::high_torsion, {5});
    scenario.stop = {};  // instead of the default limit of the force
    scenario.stop.density = 0.1;
    return is_failure(pack(scenario, arguments[1])) ? 3 : 0;
  } catch (const FileError& error) {
    std::fprintf(stderr, "pack_a_wire: %s\n", error.what());
    return 5;
  }
}
