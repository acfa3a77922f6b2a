// Whole packing runs from the empty sphere to a density; the wire radius is 1.
#include <benchmark/benchmark.h>
#include <string>

#include "wirepack/packing/quasistatic_packing.hpp"

namespace {

using namespace wirepack;

struct Run {
  Setup setup;
  double radius;       // of the sphere
  double edge_length;  // l
  double increment;    // dL
  double density;      // at the end
};

void packing(benchmark::State& bench, const Run& run) {
  Scenario scenario = default_scenario(run.setup, Cavity{run.radius});
  scenario.wire.edge_length = run.edge_length;
  scenario.insertion.increment = run.increment;
  scenario.stop.scaled_force.reset();
  scenario.stop.density = run.density;

  double evaluations = 0, evaluated_nodes = 0, start_length = 0;
  HistoryRow last;
  WorkBalance balance;
  StopReason end{};
  for (auto _ : bench) {
    QuasistaticPacking packing(scenario);
    start_length = packing.progress().last.inserted_length;
    std::optional<StopReason> reason;
    while (!reason) {
      reason = packing.advance().stop;
      const PackingProgress& progress = packing.progress();
      evaluations += progress.last.evaluations;
      evaluated_nodes += progress.last.evaluations * static_cast<double>(progress.rod.node_count());
    }
    last = packing.progress().last;
    balance = packing.progress().balance;
    end = *reason;
  }
  bench.SetLabel("ended by " + std::string(name_of(end)));
  bench.counters["density"] = last.packing_density;
  bench.counters["increments"] = last.increment;
  bench.counters["evaluations_per_increment"] = evaluations / last.increment;
  // Increments are halved where they do not resolve a jump, so costs are also per wire fed.
  const double fed = last.inserted_length - start_length;
  bench.counters["evaluations_per_length"] = evaluations / fed;
  bench.counters["ms_per_length"] =
      benchmark::Counter(1e-3 * fed, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  bench.counters["ns_per_node_and_evaluation"] = benchmark::Counter(
      1e-9 * evaluated_nodes, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  bench.counters["bend_energy"] = last.energy_bend;
  bench.counters["residue_percent"] = 100 * residue(balance, last) / balance.work;
}

void once(benchmark::internal::Benchmark* bench) {
  bench->Iterations(1)->MeasureProcessCPUTime()->Unit(benchmark::kSecond);
}

BENCHMARK_CAPTURE(packing, r10_to_10_percent, Run{Setup::low_torsion, 10, 1, 0.5, 0.1})
    ->Apply(once);
BENCHMARK_CAPTURE(packing, r10_by_edges_to_10_percent, Run{Setup::low_torsion, 10, 1, 1, 0.1})
    ->Apply(once);
BENCHMARK_CAPTURE(packing, r10_by_edges_to_30_percent, Run{Setup::low_torsion, 10, 1, 1, 0.3})
    ->Apply(once);
BENCHMARK_CAPTURE(packing, r10_coarse_to_30_percent, Run{Setup::low_torsion, 10, 2, 2, 0.3})
    ->Apply(once);
BENCHMARK_CAPTURE(packing, r5_low_to_75_percent, Run{Setup::low_torsion, 5, 1, 0.5, 0.75})
    ->Apply(once);
BENCHMARK_CAPTURE(packing, r5_high_to_75_percent, Run{Setup::high_torsion, 5, 1, 0.5, 0.75})
    ->Apply(once);
BENCHMARK_CAPTURE(packing, r20_coarse_to_3_percent, Run{Setup::low_torsion, 20, 2, 1, 0.03})
    ->Apply(once);
BENCHMARK_CAPTURE(packing, r20_by_edges_to_10_percent, Run{Setup::low_torsion, 20, 2, 2, 0.1})
    ->Apply(once);
BENCHMARK_CAPTURE(packing, r20_low_to_30_percent, Run{Setup::low_torsion, 20, 2, 2, 0.3})
    ->Apply(once);
BENCHMARK_CAPTURE(packing, r20_high_to_30_percent, Run{Setup::high_torsion, 20, 2, 2, 0.3})
    ->Apply(once);

}  // namespace
