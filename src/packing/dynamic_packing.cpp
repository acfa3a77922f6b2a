#include "wirepack/packing/dynamic_packing.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "wirepack/contact/passage.hpp"
#include "wirepack/core/error.hpp"
#include "wirepack/core/random.hpp"
#include "wirepack/dynamics/gear_integrator.hpp"
#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/feed/feeder.hpp"
#include "wirepack/packing/dynamics_values.hpp"
#include "wirepack/packing/imperfection.hpp"
#include "wirepack/packing/observation.hpp"
#include "wirepack/packing/stop_rule.hpp"
#include "wirepack/rod/rod_strain.hpp"
#include "wirepack/solve/equilibrium.hpp"

namespace wirepack {

namespace {

// Number of checks in an increment for strands that have passed through each other.
constexpr std::int64_t passage_checks = 8;
// Longest inlet edge, over l. Split earlier, it would leave less than half an edge, which asks for
// shorter steps of time.
constexpr double longest_inlet = 1.5;
// The integration has become unstable in an increment whose balance of energy misses more than this
// share of all work and dissipation in it.
constexpr double unstable_share = 0.5;

WireForces forces_of(const PackingModel& model) {
  const Scenario& scenario = model.scenario;
  WireForces forces;
  forces.wire = model.wire;
  forces.stiffness = stiffness(model.wire);
  forces.cavity = scenario.cavity;
  forces.wall_stiffness = scenario.wall_stiffness;
  if (scenario.contact_enabled) forces.contact = scenario.contact;
  if (scenario.friction.model == FrictionModel::coulomb) {
    forces.friction = stick_slip_law(scenario);
  }
  forces.damping = dynamics_values(scenario).damping;
  forces.nozzle_direction = model.nozzle.direction;
  return forces;
}

// Nordsieck values come times powers of the step. A program that chose another step may have saved
// them: of this many steps, all of one length where it has not saved that.
void change_step(MotionProgress& motion, std::int64_t steps, double step) {
  const double saved = motion.step > 0
                           ? motion.step
                           : motion.time / static_cast<double>(std::max<std::int64_t>(1, steps));
  motion.step = step;
  const double ratio = step / saved;
  if (!(saved > 0) || std::abs(ratio - 1) < 1e-6) return;  // not begun, or rounded
  for (GearValues* values : {&motion.nodes, &motion.spins}) {
    for (Index k = 1; k < values->cols(); ++k) {
      values->col(k) *= std::pow(ratio, static_cast<double>(k));
    }
  }
}

// Inserts rows into Nordsieck values before the last `tail` rows.
void insert_rows(GearValues& values, Index tail, const GearValues& rows) {
  GearValues grown(values.rows() + rows.rows(), 6);
  grown << values.topRows(values.rows() - tail), rows, values.bottomRows(tail);
  values = std::move(grown);
}

// Brings what is not held to equilibrium, if one is found. Contacts of strands are left out.
void settle(RodState& rod, const HeldUnknowns& held, PackingModel& model) {
  EquilibriumOptions options = model.options;
  options.guard = {};
  RodState settled = rod;
  const JointEnergy joints(model.wire);  // with torsion: frames move in time
  const EnergyTerms energy{model.stretch, joints, model.wall};
  const EquilibriumReport report = solve_equilibrium(settled, held, energy, options);
  if (report.end == EquilibriumEnd::converged) rod = std::move(settled);
}

// Holds everything but a node and the frames of its edges.
HeldUnknowns all_but_node(const RodState& rod, Index node) {
  HeldUnknowns held = HeldUnknowns::none(rod);
  for (Index i = 0; i < rod.node_count(); ++i) {
    if (i != node) held.hold_node(i);
  }
  for (Index j = 0; j < static_cast<Index>(rod.frames.size()); ++j) {
    held.angle[static_cast<std::size_t>(j)] = j != node - 1 && j != node;
  }
  return held;
}

// Splits the inlet edge of a moving wire. The new node starts in equilibrium between its
// neighbours, or it would swing. Its derivatives are interpolated between those of the next node
// towards the tip and those of the wire that comes out of the nozzle. The twist rate of the edge
// next to the nozzle is interpolated between those of the old edge and of the clamp.
void split_moving_inlet(DynamicState& state, PackingModel& model) {
  follow_nodes(state);
  const double share = model.wire.edge_length / state.rod.inlet_rest_length;
  split_inlet(state.rod, model.nozzle, model.wire);
  settle(state.rod, all_but_node(state.rod, state.rod.node_count() - 2), model);
  const Index clamp = state.nodes.rows() - 3;
  GearValues fed = GearValues::Zero(3, 6);
  fed.col(1) = -state.step * state.feed_speed * model.nozzle.direction;
  GearValues node = (1 - share) * state.nodes.middleRows(clamp - 3, 3) + share * fed;
  node.col(0) = state.rod.nodes.col(state.rod.node_count() - 2);
  insert_rows(state.nodes, 3, node);
  const Index frames = state.spins.rows();
  const GearValues spin =
      (1 - share) * state.spins.row(frames - 2) + share * state.spins.row(frames - 1);
  insert_rows(state.spins, 1, spin);
}

bool is_first_coil(const Scenario& scenario, double length) {
  return length <= first_coil_length(scenario.cavity);
}

// Pushes the wire off its axis before every increment until the first coil has formed, as the
// straight wire is a saddle under compression. The push has the shape of a bent cantilever, so that
// next to no energy enters.
void perturb(const Scenario& scenario, DynamicState& state, std::uint64_t& random_state) {
  if (!is_first_coil(scenario, total_rest_length(state.rod, scenario.wire))) return;
  Random random(random_state);
  const double amplitude = scenario.insertion.perturbation * scenario.wire.radius;
  const double x = amplitude * random.symmetric(), y = amplitude * random.symmetric();
  const Index last = state.rod.node_count() - 1;
  for (Index i = 0; i < last; ++i) {
    const double from_clamp = static_cast<double>(last - i) / static_cast<double>(last);
    const double bent = 1 - std::cos(pi / 2 * from_clamp);
    state.nodes(3 * i, 0) += x * bent;
    state.nodes(3 * i + 1, 0) += y * bent;
  }
  follow_nodes(state);
  random_state = random.state();
}

// A straight wire takes time to buckle. Until then the force goes far beyond that of equilibrium,
// so limits of the force count from the first coil on.
std::optional<StopReason> limit_reached(const Scenario& scenario, const PackingProgress& progress) {
  if (!is_first_coil(scenario, progress.last.inserted_length)) {
    return reached_limit(scenario, progress);
  }
  return reached_limit(scenario, progress.last, std::nullopt);
}

std::string unstable_message(double increment, double inserted_length, double time_step) {
  std::ostringstream text;
  text << "the integration has become unstable in increment " << increment
       << " (L = " << inserted_length
       << "): energies do not add up; a shorter dynamics.time_step than " << time_step
       << " may help";
  return text.str();
}

}  // namespace

UnstableIntegration::UnstableIntegration(double increment, double inserted_length, double time_step)
    : NumericalFailure(unstable_message(increment, inserted_length, time_step)),
      increment_(increment),
      inserted_length_(inserted_length),
      time_step_(time_step) {}

struct DynamicModel : PackingModel {
  explicit DynamicModel(const Scenario& configured)
      : PackingModel(configured), values(dynamics_values(scenario)) {
    // a whole number of steps to an increment
    const double time = scenario.insertion.increment / values.insertion_speed;
    step = time / std::ceil(time / values.time_step - 1e-9);
  }

  DynamicsValues values;
  double step;
};

DynamicPacking::DynamicPacking(const Scenario& scenario)
    : DynamicPacking(scenario, PackingProgress{}) {
  const Scenario& s = model_->scenario;
  progress_.rod = initial_wire(model_->nozzle, model_->wire, model_->wire.edge_length);
  settle(progress_.rod, held_by(model_->nozzle, progress_.rod), *model_);
  progress_.random_state = s.seed;
  DynamicState state = without_velocity(progress_.rod, model_->step);
  // All of the wire moves from the start.
  Points velocity = Points::Zero(3, progress_.rod.node_count());
  velocity.leftCols(progress_.rod.node_count() - 1).colwise() =
      -model_->values.insertion_speed * model_->nozzle.direction;
  set_velocities(state, velocity,
                 Eigen::VectorXd::Zero(static_cast<Index>(progress_.rod.frames.size())));
  progress_.motion = MotionProgress{state.nodes, state.spins, 0, {}, {}, model_->step};
  progress_.last = row_of(*model_, progress_.rod, observe(*model_, progress_.rod));
  EquationOfMotion motion(forces_of(*model_), s.density, held_by(model_->nozzle, progress_.rod),
                          progress_.rod);
  Rates rates;
  state.feed_speed = model_->values.insertion_speed;
  motion.set_rates(state, progress_.motion->friction, rates);
  progress_.motion->flow = motion.flow();
  progress_.last.energy_kinetic = motion.flow().kinetic;
  progress_.balance.work = motion.flow().stored();  // of the wire that was inside from the start
}

DynamicPacking::DynamicPacking(const Scenario& scenario, PackingProgress progress)
    : model_(std::make_unique<DynamicModel>(scenario)), progress_(std::move(progress)) {
  if (progress_.motion) {
    change_step(*progress_.motion, progress_.work.evaluations, model_->step);
  }
}

DynamicPacking::~DynamicPacking() = default;
DynamicPacking::DynamicPacking(DynamicPacking&&) noexcept = default;

namespace {

// Work on the wire within an increment, what has dissipated it, and what splits of the inlet edge
// took.
struct Spent {
  double insertion = 0, work = 0, friction = 0, viscous = 0, remeshing = 0;

  // The trapezoid between the flows at both ends of a step.
  void add_step(const EnergyFlow& before, const EnergyFlow& now, double step) {
    insertion += step / 2 * (before.feed + now.feed);
    work += step / 2 * (before.feed + before.medium + now.feed + now.medium);
    friction += step / 2 * (before.friction + now.friction);
    viscous += step / 2 * (before.viscous + now.viscous);
  }
};

// Energies and powers at a state, without advancing the memory of friction.
EnergyFlow flow_now(EquationOfMotion& motion, const DynamicState& state, FrictionMemory unmoved) {
  Rates rates;
  motion.set_rates(state, unmoved, rates);
  return motion.flow();
}

std::int64_t steps_of_increment(const DynamicModel& model, double inserted_length) {
  const double left =
      length_within_limits(model.scenario, inserted_length, model.scenario.insertion.increment);
  const double step = model.values.insertion_speed * model.step;
  return std::max<std::int64_t>(1, std::llround(std::ceil(left / step - 1e-6)));
}

// Takes the steps of an increment; nothing if strands have passed through each other.
std::optional<Spent> integrate(DynamicModel& model, std::int64_t steps, DynamicState& state,
                               EquationOfMotion& motion, MotionProgress& moving) {
  const Index separation = first_touching_neighbor(
      {2 * model.wire.radius, model.wire.edge_length, model.scenario.contact.excluded_arc_length});
  Spent spent;
  Rates rates;
  RodState checked = state.rod;
  for (std::int64_t k = 1; k <= steps; ++k) {
    const EnergyFlow before = moving.flow;
    gear_step(
        state,
        [&](const DynamicState& at, Rates& out) { motion.set_rates(at, moving.friction, out); },
        rates);
    moving.flow = motion.flow();
    spent.add_step(before, moving.flow, state.step);
    if (split_is_due(state.rod, longest_inlet * model.wire.edge_length)) {
      follow_nodes(state);
      const EnergyFlow old = flow_now(motion, state, moving.friction);
      state.rod.twist_guide = joint_twists(state.rod);
      split_moving_inlet(state, model);
      motion.resize(state.rod, held_by(model.nozzle, state.rod));
      moving.flow = flow_now(motion, state, moving.friction);
      spent.remeshing += old.stored() - moving.flow.stored();
    }
    if (model.scenario.contact_enabled && (k * passage_checks) % steps < passage_checks) {
      if (!passed_pairs(checked, state.rod, separation).empty()) return std::nullopt;
      checked = state.rod;
    }
  }
  return spent;
}

HistoryRow record(PackingModel& model, const PackingProgress& from, const RodState& rod,
                  const Spent& spent, const EnergyFlow& flow) {
  HistoryRow row = row_of(model, rod, observe(model, rod));
  const double fed = row.inserted_length - from.last.inserted_length;
  row.increment = from.last.increment + 1;
  row.energy_total = flow.potential + flow.stick;
  row.energy_kinetic = flow.kinetic;
  row.force = spent.insertion / fed;
  row.force_difference = (row.energy_total - from.last.energy_total) / fed;
  row.scaled_force = row.force / force_unit(model.scenario);
  row.work = spent.work;
  row.viscous_dissipation = spent.viscous;
  row.friction_dissipation = spent.friction - (flow.stick - from.motion->flow.stick);
  row.wall_seconds = from.last.wall_seconds;
  return row;
}

// Books the work. Throws where the energies of the increment do not add up.
void account(const DynamicModel& model, const Spent& spent, const PackingProgress& from,
             PackingProgress& next) {
  HistoryRow& row = next.last;
  next.balance.work += spent.work;
  next.balance.friction += row.friction_dissipation;
  next.balance.viscous += spent.viscous;
  next.balance.remeshing += spent.remeshing;
  const double missing = residue(next.balance, row);
  row.audit_residual = missing / next.balance.work;
  const double change = missing - residue(from.balance, from.last);
  const double fed = row.inserted_length - from.last.inserted_length;
  const double turnover = std::abs(spent.work) + std::abs(spent.friction) + spent.viscous +
                          force_unit(model.scenario) * fed;
  if (!(std::abs(change) < unstable_share * turnover)) {
    throw UnstableIntegration(row.increment, row.inserted_length, model.step);
  }
}

}  // namespace

Advance DynamicPacking::advance() {
  PackingProgress next = progress_;
  MotionProgress& moving = *next.motion;
  DynamicState state{next.rod,    moving.nodes, moving.spins,
                     moving.time, model_->step, model_->values.insertion_speed};
  EquationOfMotion motion(forces_of(*model_), model_->scenario.density,
                          held_by(model_->nozzle, state.rod), state.rod);
  perturb(model_->scenario, state, next.random_state);
  const std::int64_t steps = steps_of_increment(*model_, progress_.last.inserted_length);
  const std::optional<Spent> spent = integrate(*model_, steps, state, motion, moving);
  if (!spent) return {std::nullopt, StopReason::strands_passed};

  follow_nodes(state);
  state.rod.twist_guide = joint_twists(state.rod);
  EnergyFlow flow = flow_now(motion, state, moving.friction);
  flow.stick = moving.flow.stick;
  next.rod = state.rod;
  moving.nodes = state.nodes;
  moving.spins = state.spins;
  moving.time = state.time;
  next.work.evaluations += steps;
  next.last = record(*model_, progress_, next.rod, *spent, flow);
  next.last.evaluations = static_cast<double>(steps);
  next.last.time = state.time;
  account(*model_, *spent, progress_, next);
  note_force(model_->scenario, next);
  progress_ = std::move(next);
  return {progress_.last, limit_reached(model_->scenario, progress_)};
}

bool DynamicPacking::frame_is_due() const {
  return wirepack::frame_is_due(model_->scenario, progress_);
}

PackingFrame DynamicPacking::take_frame() { return wirepack::take_frame(*model_, progress_); }

}  // namespace wirepack
