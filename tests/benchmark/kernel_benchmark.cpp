// Cost of the parts of one evaluation and of one factorization, on states of a real packing.
#include <benchmark/benchmark.h>
#include <map>

#include "wirepack/contact/neighbor_list.hpp"
#include "wirepack/contact/passage.hpp"
#include "wirepack/core/random.hpp"
#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/self_contact_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/energy/wall_energy.hpp"
#include "wirepack/packing/quasistatic_packing.hpp"
#include "wirepack/rod/turning_chart.hpp"
#include "wirepack/solve/preconditioner.hpp"

namespace {

using namespace wirepack;

// Low torsion in a sphere of 10 wire radii, whole edges at a time, which is quickest.
Scenario packed_scenario() {
  Scenario scenario = default_scenario(Setup::low_torsion, Cavity{10});
  scenario.insertion.increment = scenario.wire.edge_length;
  scenario.stop.scaled_force.reset();
  scenario.stop.density = 0.31;
  return scenario;
}

// The rod of that run at a density, and at the increment before.
struct PackedRod {
  RodState before, now;
};

// One run for all benchmarks, made when the first of them asks; density in percent.
const PackedRod& packed_rod(std::int64_t percent) {
  static const std::map<std::int64_t, PackedRod> rods = [] {
    std::map<std::int64_t, PackedRod> taken;
    QuasistaticPacking packing(packed_scenario());
    for (const std::int64_t wanted : {10, 30}) {
      PackedRod& rod = taken[wanted];
      while (packing.progress().last.packing_density < static_cast<double>(wanted) / 100) {
        rod.before = packing.progress().rod;
        if (packing.advance().stop) break;
      }
      rod.now = packing.progress().rod;
    }
    return taken;
  }();
  return rods.at(percent);
}

enum class Torsion { none, free };

// What the minimizer works on: the chart of the packed rod and a point in the middle of a descent.
// Without torsion the angles are held; with it they are free and the wire is curved at rest.
struct Descent {
  Torsion torsion;
  Scenario scenario;
  const PackedRod& rod;
  StretchEnergy stretch{scenario.wire};
  JointEnergy joints{scenario.wire, joint_stiffness(scenario.wire, torsion)};
  WallEnergy wall{scenario.wire, scenario.cavity, scenario.wall_stiffness};
  SelfContactEnergy contact{scenario.wire, scenario.contact};
  FrameChart chart;
  Eigen::VectorXd x;
  RodState state;

  explicit Descent(const benchmark::State& bench, Torsion with = Torsion::none)
      : torsion(with),
        scenario(scenario_with(torsion)),
        rod(packed_rod(bench.range(0))),
        chart(rod.now, held(scenario, rod.now, torsion)) {
    x = chart.unknowns();
    Random random(1);
    for (double& u : x) u += 1e-3 * scenario.wire.radius * random.symmetric();
    state = chart.reference();
    chart.set_state(x, state);
    contact.prepare(state);
  }

  static Scenario scenario_with(Torsion torsion) {
    Scenario scenario = packed_scenario();
    if (torsion == Torsion::free) {
      const Scenario high = default_scenario(Setup::high_torsion, scenario.cavity);
      scenario.wire.rest_darboux = high.wire.rest_darboux;
      scenario.nozzle.twist = high.nozzle.twist;
    }
    return scenario;
  }
  static Stiffness joint_stiffness(const RodParams& params, Torsion torsion) {
    Stiffness result = stiffness(params);
    if (torsion == Torsion::none) result.twist = 0;
    return result;
  }
  static HeldUnknowns held(const Scenario& scenario, const RodState& rod, Torsion torsion) {
    HeldUnknowns result =
        held_by(nozzle_at_wall(scenario.nozzle, scenario.cavity, scenario.wire.radius), rod);
    if (torsion == Torsion::free) return result;
    result.angle.assign(result.angle.size(), true);
    result.frames_follow = false;
    return result;
  }
  ContactRange contact_range() const {
    return {2 * scenario.wire.radius, scenario.wire.edge_length,
            scenario.contact.excluded_arc_length};
  }
  auto energy() { return EnergyTerms{stretch, joints, wall, contact}; }
  double shift() const { return scenario.minimizer.shift * stiffness(scenario.wire).bend; }
  Eigen::SparseMatrix<double> curvature() {
    CurvatureModel model(chart);
    energy().add_curvature(chart.reference(), model);
    return model.lower_triangle(shift(), shift());
  }
};

// CPU time over iterations and nodes.
void count_nodes(benchmark::State& bench, const Descent& descent) {
  const auto nodes = static_cast<double>(descent.state.node_count());
  bench.counters["nodes"] = nodes;
  bench.counters["ns_per_node"] = benchmark::Counter(
      1e-9 * nodes, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <EnergyTerm Term>
void measure_term(benchmark::State& bench, const Descent& descent, const Term& term) {
  Gradient gradient;
  for (auto _ : bench) {
    set_zero(gradient, descent.state);
    benchmark::DoNotOptimize(term.add_gradient(descent.state, gradient));
  }
  count_nodes(bench, descent);
}

void stretch(benchmark::State& bench) {
  const Descent descent(bench);
  measure_term(bench, descent, descent.stretch);
}

void joints(benchmark::State& bench, Torsion torsion) {
  const Descent descent(bench, torsion);
  measure_term(bench, descent, descent.joints);
}

void wall(benchmark::State& bench) {
  const Descent descent(bench);
  measure_term(bench, descent, descent.wall);
}

void contact(benchmark::State& bench) {
  const Descent descent(bench);
  measure_term(bench, descent, descent.contact);
  const auto nodes = static_cast<double>(descent.state.node_count());
  const auto touching = static_cast<double>(descent.contact.contacts(descent.state).size());
  bench.counters["touching_pairs_per_node"] = touching / nodes;
}

void chart(benchmark::State& bench, Torsion torsion) {
  Descent descent(bench, torsion);
  const Eigen::VectorXd x = descent.x;
  Gradient gradient;
  set_zero(gradient, descent.state);
  descent.energy().add_gradient(descent.state, gradient);
  Eigen::VectorXd by_x;
  for (auto _ : bench) {
    descent.chart.set_state(x, descent.state);
    descent.chart.pull_back(descent.state, gradient.node, gradient.frame, by_x);
    benchmark::DoNotOptimize(by_x.data());
  }
  count_nodes(bench, descent);
}

// From the unknowns to the energy and its gradient by the unknowns; no triangular solves.
template <EnergyTerm Energy>
double evaluate(const Descent& descent, const Energy& energy, const Eigen::VectorXd& x,
                RodState& state, Gradient& gradient, Eigen::VectorXd& by_x) {
  descent.chart.set_state(x, state);
  set_zero(gradient, state);
  const double value = energy.add_gradient(state, gradient);
  descent.chart.pull_back(state, gradient.node, gradient.frame, by_x);
  return value;
}

void elastic_gradient(benchmark::State& bench, Torsion torsion) {
  Descent descent(bench, torsion);
  const EnergyTerms energy{descent.stretch, descent.joints};
  Gradient gradient;
  Eigen::VectorXd by_x;
  for (auto _ : bench) {
    benchmark::DoNotOptimize(evaluate(descent, energy, descent.x, descent.state, gradient, by_x));
  }
  count_nodes(bench, descent);
}

// The same with the chart that turns with the wire.
template <EnergyTerm Energy>
double evaluate(const Energy& energy, const Eigen::VectorXd& step, TurningChart& turning,
                RodState& state, Gradient& gradient, Eigen::VectorXd& by_x,
                Eigen::VectorXd& by_step) {
  turning.set_state(step, state);
  set_zero(gradient, state);
  const double value = energy.add_gradient(state, gradient);
  turning.pull_back(state, gradient.node, gradient.frame, Points(), by_x, by_step);
  return value;
}

// An evaluation of the minimizer, but for the triangular solves and the guard.
void full_gradient(benchmark::State& bench, Torsion torsion) {
  Descent descent(bench, torsion);
  const auto energy = descent.energy();
  TurningChart turning(descent.chart, descent.scenario.cavity.radius);
  const Eigen::VectorXd step = descent.x - descent.chart.unknowns();
  Gradient gradient;
  Eigen::VectorXd by_x, by_step;
  for (auto _ : bench) {
    benchmark::DoNotOptimize(
        evaluate(energy, step, turning, descent.state, gradient, by_x, by_step));
  }
  count_nodes(bench, descent);
}

void turning_chart(benchmark::State& bench, Torsion torsion) {
  Descent descent(bench, torsion);
  const EnergyTerms energy{descent.stretch, descent.joints};
  TurningChart turning(descent.chart, descent.scenario.cavity.radius);
  const Eigen::VectorXd step = descent.x - descent.chart.unknowns();
  Gradient gradient;
  Eigen::VectorXd by_x, by_step;
  evaluate(energy, step, turning, descent.state, gradient, by_x, by_step);
  for (auto _ : bench) {
    turning.set_state(step, descent.state);
    turning.pull_back(descent.state, gradient.node, gradient.frame, Points(), by_x, by_step);
    benchmark::DoNotOptimize(by_step.data());
  }
  count_nodes(bench, descent);
}

void neighbor_list(benchmark::State& bench) {
  const Descent descent(bench);
  const double skin = descent.scenario.wire.radius;  // that of SelfContactEnergy
  NeighborList list;
  for (auto _ : bench) {
    list = NeighborList(descent.state, descent.contact_range(), skin);
    benchmark::DoNotOptimize(list.fours().data());
  }
  count_nodes(bench, descent);
  bench.counters["candidate_pairs_per_node"] =
      static_cast<double>(list.pairs().size()) / static_cast<double>(descent.state.node_count());
}

void passage_check(benchmark::State& bench) {
  const Descent descent(bench);
  const Index separation = first_touching_neighbor(descent.contact_range());
  for (auto _ : bench) {
    benchmark::DoNotOptimize(passed_pairs(descent.rod.before, descent.rod.now, separation));
  }
  count_nodes(bench, descent);
}

void curvature_assembly(benchmark::State& bench) {
  Descent descent(bench);
  for (auto _ : bench) benchmark::DoNotOptimize(descent.curvature());
  count_nodes(bench, descent);
}

Preconditioner factored(const Descent& descent, const Eigen::SparseMatrix<double>& lower) {
  return *Preconditioner::factored(lower, descent.shift(), Preconditioner::Definiteness::unknown);
}

void factorization(benchmark::State& bench) {
  Descent descent(bench);
  const Eigen::SparseMatrix<double> lower = descent.curvature();
  double factor_size = 0;
  for (auto _ : bench) factor_size = factored(descent, lower).factor_size();
  count_nodes(bench, descent);
  const auto nodes = static_cast<double>(descent.state.node_count());
  bench.counters["factor_nonzeros_per_node"] = factor_size / nodes;
  bench.counters["matrix_nonzeros_per_node"] = static_cast<double>(lower.nonZeros()) / nodes;
}

void triangular_solves(benchmark::State& bench) {
  Descent descent(bench);
  Preconditioner preconditioner = factored(descent, descent.curvature());
  const Eigen::VectorXd y = descent.x;
  Eigen::VectorXd step, by_y;
  for (auto _ : bench) {
    preconditioner.to_step(y, step);
    preconditioner.to_gradient(y, by_y);
    benchmark::DoNotOptimize(by_y.data());
  }
  count_nodes(bench, descent);
}

void kernel(benchmark::internal::Benchmark* bench) {
  bench->ArgName("phi_percent")->Arg(10)->Arg(30);
  bench->MeasureProcessCPUTime()->Unit(benchmark::kMicrosecond);
}

BENCHMARK(stretch)->Apply(kernel);
BENCHMARK_CAPTURE(joints, plain, Torsion::none)->Apply(kernel);
BENCHMARK_CAPTURE(joints, twist, Torsion::free)->Apply(kernel);
BENCHMARK_CAPTURE(chart, plain, Torsion::none)->Apply(kernel);
BENCHMARK_CAPTURE(chart, twist, Torsion::free)->Apply(kernel);
BENCHMARK_CAPTURE(turning_chart, plain, Torsion::none)->Apply(kernel);
BENCHMARK_CAPTURE(turning_chart, twist, Torsion::free)->Apply(kernel);
BENCHMARK_CAPTURE(elastic_gradient, plain, Torsion::none)->Apply(kernel);
BENCHMARK_CAPTURE(elastic_gradient, twist, Torsion::free)->Apply(kernel);
BENCHMARK(wall)->Apply(kernel);
BENCHMARK(contact)->Apply(kernel);
BENCHMARK_CAPTURE(full_gradient, plain, Torsion::none)->Apply(kernel);
BENCHMARK_CAPTURE(full_gradient, twist, Torsion::free)->Apply(kernel);
BENCHMARK(triangular_solves)->Apply(kernel);
BENCHMARK(neighbor_list)->Apply(kernel);
BENCHMARK(passage_check)->Apply(kernel);
BENCHMARK(curvature_assembly)->Apply(kernel);
BENCHMARK(factorization)->Apply(kernel);

}  // namespace
