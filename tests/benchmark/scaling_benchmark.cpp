// What an edge of wire costs at some densities and sizes of the sphere, and what threads bring: the
// wire radius is 1, low torsion, fed by whole edges. The run up to the density is not timed.
#include <benchmark/benchmark.h>
#include <chrono>
#include <ctime>

#include "wirepack/core/threads.hpp"
#include "wirepack/packing/quasistatic_packing.hpp"

namespace {

using namespace wirepack;

// CPU time of the process, which other programs disturb less than the time of day.
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Scenario scenario_to(double radius, double density) {
  Scenario scenario = default_scenario(Setup::low_torsion, Cavity{radius});
  scenario.insertion.increment = scenario.wire.edge_length;
  scenario.stop.scaled_force.reset();
  scenario.stop.density = density;
  return scenario;
}

void edge_cost(benchmark::State& bench) {
  const double density = static_cast<double>(bench.range(1)) / 1000;
  const Scenario scenario = scenario_to(static_cast<double>(bench.range(0)), 1.1 * density);

  use_threads(1);
  PackingProgress before, after;
  for (auto _ : bench) {
    QuasistaticPacking packing(scenario);
    while (packing.progress().last.packing_density < density && !packing.advance().stop) {
    }
    before = packing.progress();
    const double start = cpu_seconds();
    while (!packing.advance().stop) {
    }
    bench.SetIterationTime(cpu_seconds() - start);
    after = packing.progress();
  }
  const double edges =
      (after.last.inserted_length - before.last.inserted_length) / scenario.wire.edge_length;
  const auto per_edge = [&](auto first, auto last) {
    return static_cast<double>(last - first) / edges;
  };
  bench.counters["nodes"] =
      static_cast<double>(before.rod.node_count() + after.rod.node_count()) / 2;
  bench.counters["increments_per_edge"] = per_edge(before.last.increment, after.last.increment);
  bench.counters["evaluations_per_edge"] =
      per_edge(before.work.evaluations, after.work.evaluations);
  bench.counters["factorizations_per_edge"] =
      per_edge(before.work.factorizations, after.work.factorizations);
  bench.counters["ms_per_edge"] =
      benchmark::Counter(1e-3 * edges, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

BENCHMARK(edge_cost)
    ->ArgNames({"radius", "phi_permille"})
    ->ArgsProduct({{5}, {200, 400, 600}})
    ->ArgsProduct({{10}, {50, 100, 200, 300}})
    ->ArgsProduct({{20}, {20, 50, 100, 200}})
    ->ArgsProduct({{40}, {5, 10, 20, 40}})
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kSecond);

// Seconds of the clock, as threads take CPU time together. Compare within one run.
void edges_by_threads(benchmark::State& bench) {
  const double density = 0.2;
  static const PackingProgress start = [&] {
    QuasistaticPacking packing(scenario_to(20, density));
    while (!packing.advance().stop) {
    }
    return packing.progress();
  }();
  use_threads(static_cast<int>(bench.range(0)));
  PackingProgress after;
  for (auto _ : bench) {
    QuasistaticPacking packing(scenario_to(20, density + 0.005), start);
    const auto clock = std::chrono::steady_clock::now();
    while (!packing.advance().stop) {
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - clock;
    bench.SetIterationTime(passed.count());
    after = packing.progress();
  }
  bench.counters["nodes"] = static_cast<double>(after.rod.node_count());
  bench.counters["evaluations"] =
      static_cast<double>(after.work.evaluations - start.work.evaluations);
}

BENCHMARK(edges_by_threads)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kSecond);

}  // namespace
