#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "wirepack/core/error.hpp"
#include "wirepack/io/config_file.hpp"
#include "wirepack/io/hdf5_reader.hpp"
#include "wirepack/io/output_path.hpp"
#include "wirepack/io/recorded_run.hpp"
#include "wirepack/io/result_lock.hpp"
#include "wirepack/observe/spool_model.hpp"
#include "wirepack/packing/equilibrate.hpp"
#include "wirepack/packing/longest_wire.hpp"
#include "wirepack/packing/packing_model.hpp"
#include "wirepack/packing/packing_run.hpp"
#include "wirepack/packing/warnings.hpp"
#include "wirepack/packing/wire_in_nozzle.hpp"
#include "wirepack/rod/frame_chart.hpp"

#include "module.hpp"

namespace wirepack {

namespace {

using py::literals::operator""_a;
using Path = std::filesystem::path;
using Texts = std::vector<std::string>;
using Numbers = std::map<std::string, double>;

// Assignments of a configuration, and those that take their place.
std::vector<ConfigOverride> overrides(const Texts& config, const Texts& set) {
  std::vector<ConfigOverride> result;
  for (const std::string& assignment : config) result.push_back({assignment, "config"});
  for (const std::string& assignment : set) result.push_back({assignment, "set"});
  return result;
}

StopLimits stop_limits(const Numbers& given) {
  const auto limit = [&](const char* name) {
    const auto found = given.find(name);
    return found == given.end() ? std::nullopt : std::optional(found->second);
  };
  return {limit("scaled_force"), limit("force"), limit("density"), limit("length"), std::nullopt};
}

// Begins a result, or goes on with it: to the limits of the configuration or, where some are given,
// to those, and by at most so many increments. A signal such as Ctrl-C ends it between two. Returns
// the limit that was reached, warnings, and what else was said.
std::tuple<std::optional<std::string>, Texts, Texts> run(
    const Configuration& config, const Path& file, Existing existing, const std::string& call,
    const Numbers& limits, std::optional<std::int64_t> increments, int threads) {
  Scenario scenario = config.scenario;
  if (!limits.empty()) scenario.stop = stop_limits(limits);
  const RecordOptions options{
      existing,
      call,
      {{"length_unit", config.units.length}, {"force_unit", config.units.force}},
      config.given_keys};
  Texts said;
  bool interrupted = false;
  RunHooks hooks;
  hooks.say = [&](const std::string& message) { said.push_back(message); };
  hooks.stop_requested = [&] {
    if (increments && (*increments)-- == 0) return true;
    const py::gil_scoped_acquire acquire;
    interrupted = PyErr_CheckSignals() != 0;
    return interrupted;
  };
  const RecordedRun found = [&] {
    const Computing computing;
    const Threads shared(threads);
    return run_recorded(scenario, file, options, hooks);
  }();
  if (interrupted) throw py::error_already_set();
  std::optional<std::string> limit;
  if (found.stop) limit = std::string(name_of(*found.stop));
  return {limit, found.warnings, said};
}

// The wire where a result has come to, in the units of the scenario.
PackingFrame frame_now(const Configuration& config, const Path& file) {
  return PackingRun(config.scenario, Hdf5Reader(file).progress()).take_frame();
}

Quaternions quaternions(const RodState& rod) {
  Quaternions result(rod.edge_count(), 4);
  for (Index j = 0; j < rod.edge_count(); ++j) {
    const Quat& q = rod.frames[static_cast<std::size_t>(j)];
    result.row(j) << q.w(), q.x(), q.y(), q.z();
  }
  return result;
}

py::dict values_of(const PackingFrame& frame) {
  const auto count = static_cast<Index>(frame.contacts.size());
  Eigen::Matrix<std::int64_t, Eigen::Dynamic, 2> pairs(count, 2);
  Eigen::VectorXd forces(count);
  for (Index k = 0; k < count; ++k) {
    const SelfContact& contact = frame.contacts[static_cast<std::size_t>(k)];
    pairs.row(k) << contact.edges.first, contact.edges.second;
    forces[k] = contact.force;
  }
  return py::dict("increment"_a = static_cast<std::int64_t>(frame.increment),
                  "inserted_length"_a = frame.inserted_length,
                  "packing_density"_a = frame.packing_density, "force"_a = frame.force,
                  "position"_a = Positions(frame.rod.nodes.transpose()),
                  "quaternion"_a = quaternions(frame.rod), "bend_energy"_a = frame.bend_energy,
                  "twist_energy"_a = frame.twist_energy, "wall_force"_a = frame.wall_force,
                  "contact_pairs"_a = pairs, "contact_force"_a = forces);
}

py::dict frame_values(const Configuration& config, const Path& file) {
  const PackingFrame frame = [&] {
    const Computing computing;
    return frame_now(config, file);
  }();
  return values_of(frame);
}

// A wire through these nodes that ends in the nozzle: see wire_in_nozzle(). Without a length, all
// of its edges are whole.
RodState rod_in_nozzle(const PackingModel& model, const Positions& position,
                       const std::optional<Quaternions>& quaternion,
                       std::optional<double> inserted_length) {
  const Index edges = position.rows() - 1;
  const std::vector<Quat> frames = quaternion ? frames_of(*quaternion, edges) : std::vector<Quat>();
  return wire_in_nozzle(
      model, position.transpose(), frames,
      inserted_length.value_or(static_cast<double>(edges) * model.wire.edge_length));
}

// Energies by term, derivatives by nodes, by the turning of edges and by the length of the wire.
// Frames, which need not be those of the edges, are carried onto them by the smallest rotations.
using Energies = std::tuple<Numbers, Positions, Eigen::VectorXd, double>;
Energies energies(PackingModel& model, RodState rod) {
  const FrameChart chart(rod, HeldUnknowns::none(rod));
  carry_frames(rod);
  const JointEnergy joints(model.wire);
  EnergyTerms terms{model.stretch, joints, model.wall};
  if (model.scenario.contact_enabled) terms.add(model.contact);
  terms.prepare(rod);
  Gradient gradient;
  set_zero(gradient, rod);
  Numbers found;
  for (const auto& [name, energy] : terms.breakdown(rod, gradient)) {
    if (!std::isfinite(energy))
      throw NumericalFailure(fmt::format("the {} energy is not finite", name));
    found.emplace(name, energy);
  }
  found.erase(std::string(JointEnergy::name));  // kept apart, as in the history
  const JointEnergies apart = joint_energies(model.wire, rod);
  found.insert({{"bend", apart.bend}, {"twist", apart.twist}});
  Eigen::VectorXd by_unknown, by_angle;
  chart.pull_back(rod, gradient.node, gradient.frame, by_unknown);
  chart.scatter(by_unknown, gradient.node);
  chart.scatter_angles(by_unknown, by_angle);
  const Index clamp = rod.last_clamp_frame();
  // A nozzle that is free to turn does so with the last edge.
  if (model.nozzle.twist == TwistCondition::free) by_angle[clamp - 1] += by_angle[clamp];
  by_angle.conservativeResize(rod.edge_count());
  return {found, gradient.node.transpose(), by_angle, gradient.inlet_length};
}

Energies energies_at(const Configuration& config, const Positions& position,
                     const std::optional<Quaternions>& quaternion,
                     std::optional<double> inserted_length) {
  PackingModel model(config.scenario);
  return energies(model, rod_in_nozzle(model, position, quaternion, inserted_length));
}

Energies energies_now(const Configuration& config, const Path& file) {
  PackingModel model(config.scenario);
  return energies(model, frame_now(config, file).rod);
}

// Why what was found is no minimum; empty if it is one.
std::string fault_of(const EquilibriumReport& report) {
  if (report.end != EquilibriumEnd::converged) {
    return fmt::format("no equilibrium: forces are {:.3g} times the tolerance after {} evaluations",
                       report.residual, report.work.evaluations);
  }
  return report.stable ? "" : "no minimum: a saddle that could not be left";
}

// A wire can have an equilibrium in a nozzle where it ends, with edges of this scenario.
void require_in_nozzle(const PackingModel& model, const RodState& rod) {
  const double off = (rod.nodes.rightCols<1>() - model.nozzle.position).norm();
  if (!(off < 1e-6 * model.wire.radius)) {
    throw InvalidInput(fmt::format("position: ends {} from the nozzle of this scenario", off));
  }
  const double longest = 1.6 * model.wire.edge_length;  // one of 1.5 has been split
  if (rod.inlet_rest_length > longest) {
    throw InvalidInput(fmt::format(
        "inserted_length: leaves {} to the last edge, which has {} at most in this scenario",
        rod.inlet_rest_length, longest));
  }
}

// The minimum that a wire comes to from these positions without friction, and what kept it from
// one: nothing, if it is in equilibrium.
std::tuple<py::dict, std::string> relaxed(const Configuration& config, const Positions& position,
                                          const std::optional<Quaternions>& quaternion,
                                          std::optional<double> inserted_length, int threads) {
  std::string fault;
  const PackingFrame frame = [&] {
    const Computing computing;
    const Threads shared(threads);
    Scenario scenario = config.scenario;
    scenario.friction.model = FrictionModel::none;
    PackingModel model(scenario);
    PackingProgress progress;
    progress.rod = rod_in_nozzle(model, position, quaternion, inserted_length);
    carry_frames(progress.rod);
    require_in_nozzle(model, progress.rod);
    const RodState before = progress.rod;
    const Equilibrium found = equilibrate(model, before, progress.rod);
    progress.last = row_of(model, progress.rod, found.observed);
    progress.last.force = found.report.inlet_length_force;
    fault = fault_of(found.report);
    return take_frame(model, progress);
  }();
  return {values_of(frame), fault};
}

double spool_energy(const Configuration& config, double density, double spacing) {
  const Scenario& scenario = config.scenario;
  if (scenario.cavity.semi_axes)
    throw InvalidInput("the model of a spool is that of a sphere; cavity.shape = \"ellipsoid\"");
  if (!(spacing >= 2 && std::isfinite(spacing)))
    throw InvalidInput(fmt::format("spacing = {}: must be finite and at least 2", spacing));
  const double a = scenario.wire.radius;
  const SpoolModel spool{scenario.cavity, a, stiffness(scenario.wire).bend, spacing * a};
  return spool.bend_energy(density);
}

}  // namespace

void add_packing(py::module_& module) {
  py::enum_<Existing>(module, "_Existing")
      .value("refuse", Existing::refuse)
      .value("replace", Existing::replace)
      .value("go_on", Existing::go_on);
  py::class_<Configuration>(module, "_Configuration")
      .def_readonly("inputs", &Configuration::inputs)
      .def_property_readonly("warnings", [](const Configuration& config) {
        return warnings(config.scenario, expected_length(config.scenario));
      });
  module.def("_read", [](const Path& file, const Texts& set) {
    return read_configuration(file, overrides({}, set));
  });
  module.def("_parse", [](const std::string& text, const Texts& config, const Texts& set) {
    return parse_configuration(text, "config", overrides(config, set));
  });
  py::class_<ResultLock>(module, "_ResultLock").def(py::init<const Path&>());
  module.def("_output_file", [](const Path& file, const std::vector<Path>& inputs, bool force,
                                const std::string& remedy) {
    return output_file(file, {inputs, force, remedy});
  });
  module.def("_run", run);
  module.def("_frame", frame_values);
  module.def("_relaxed", relaxed);
  module.def("_spool_energy", spool_energy);
  module.def("_energies_at", energies_at, py::call_guard<Computing>());
  module.def("_energies_now", energies_now, py::call_guard<Computing>());
}

}  // namespace wirepack
