// Lets go of the friction in a packing: relax_without_friction RESULT.h5 [INCREMENT]. The wire of
// the last frame, or of that of an increment, finds its equilibrium at its length.
#include <cstdio>
#include <exception>

#include <wirepack/core/error.hpp>
#include <wirepack/io/hdf5_reader.hpp>
#include <wirepack/observe/coil_report.hpp>
#include <wirepack/packing/equilibrate.hpp>
#include <wirepack/packing/wire_in_nozzle.hpp>

using namespace wirepack;

namespace {

PackingFrame chosen_frame(const Hdf5Reader& result, const std::string& increment) {
  std::string known;
  for (const std::int64_t k : result.frame_increments()) {
    if (std::to_string(k) == increment) return result.frame(k);
    known.append(" ").append(std::to_string(k));
  }
  if (increment.empty() && !known.empty()) return result.frame(result.frame_increments().back());
  throw InvalidInput("no frame \"" + increment + "\"; increments with a frame:" + known);
}

void print(const char* name, PackingModel& model, const RodState& rod) {
  const Observation o = observe(model, rod);
  const double total =
      o.energy_stretch + o.energy_bend + o.energy_twist + o.energy_wall + o.energy_contact;
  const double unit = units_of(model.scenario).scaled_energy();
  std::printf("%-15s %10.4f %10.4f %10.4f %10.4f\n", name, total / unit, o.energy_bend / unit,
              o.energy_twist / unit, coil_report(rod, model.nozzle.direction).axis_order);
}

int relax(const Hdf5Reader& result, const std::string& increment) {
  Scenario scenario = result.scenario();
  if (scenario.friction.model == FrictionModel::none)
    throw InvalidInput("friction.model = \"none\": the result is of a run without friction");
  scenario.friction.model = FrictionModel::none;
  PackingModel model(scenario);
  const RodState packed = wire_in_nozzle(model, chosen_frame(result, increment));
  RodState relaxed = packed;
  const Equilibrium found = equilibrate(model, packed, relaxed);
  std::puts("energies, R/YI       all       bend      twist  order of axes");
  print("with friction", model, packed);
  print("relaxed", model, relaxed);
  const double move = (relaxed.nodes - packed.nodes).colwise().norm().maxCoeff();
  const bool in_equilibrium = found.report.end == EquilibriumEnd::converged;
  const char* end = !in_equilibrium       ? "no equilibrium"
                    : found.report.stable ? "a minimum"
                                          : "a saddle";
  std::printf("farthest move %.4g a, residual %.2g, %s\n", move / model.wire.radius,
              found.report.residual, end);
  return in_equilibrium && found.report.stable ? 0 : 3;
}

int report(const std::exception& error, int code) {
  std::fprintf(stderr, "relax_without_friction: %s\n", error.what());
  return code;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    if (count != 2 && count != 3) throw InvalidInput("usage: RESULT.h5 [INCREMENT]");
    return relax(Hdf5Reader(arguments[1]), count == 3 ? arguments[2] : "");
  } catch (const InvalidInput& error) {
    return report(error, 2);
  } catch (const FileError& error) {
    return report(error, 5);
  } catch (const std::exception& error) {  // NumericalFailure, or no memory
    return report(error, 4);
  }
}
