// Packs a wire and keeps a result file: pack_a_wire OUT.h5. A second call goes on where the first
// one was interrupted. Exit codes are those of the program wirepack.
#include <cstdio>
#include <exception>

#include <wirepack/core/error.hpp>
#include <wirepack/io/recorded_run.hpp>
#include <wirepack/io/result_end.hpp>

namespace {

int report(const std::exception& error, int code) {
  std::fprintf(stderr, "pack_a_wire: %s\n", error.what());
  return code;
}

int pack_into(const char* file) {
  using namespace wirepack;
  Scenario scenario = default_scenario(Setup::high_torsion, {5});
  scenario.stop = {};  // instead of the default limit of the force
  scenario.stop.density = 0.1;
  const RecordedRun run =
      run_recorded(scenario, file, {.existing = Existing::go_on, .command_line = "pack_a_wire"});
  std::printf("phi = %.4f, F R^2/YI = %.4f, %.0f contacts\n", run.last.packing_density,
              run.last.scaled_force, run.last.contacts);
  return found_no_equilibrium(*run.stop) ? 3 : 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: pack_a_wire OUT.h5\n", stderr);
    return 2;
  }
  try {
    return pack_into(arguments[1]);
  } catch (const wirepack::InvalidInput& error) {
    return report(error, 2);
  } catch (const wirepack::FileError& error) {
    return report(error, 5);
  } catch (const std::exception& error) {  // NumericalFailure, or no memory
    return report(error, 4);
  }
}
