// A rod without contact, against solvers made for such rods: length 200, radius 1, Y = 5, in N
// edges, the two nodes at each end held on one line, 160 apart end to end, buckled.
// Reference: E = 0.165038696 and middle height 53.07813 at N = 200.
#include <benchmark/benchmark.h>
#include <cmath>

#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/solve/equilibrium.hpp"

namespace {

using namespace wirepack;

constexpr double length = 200, chord = 160;

// Residual at rest over YI / L^2 and YI / L. At N = 10000 the rounding of positions alone leaves
// 5e-4 of it in the axial springs; energies agree to nine digits at ten times as much.
constexpr double tolerance = 1e-3;

enum class Start {
  arch,      // tangents at angles alpha sin(2 pi s): near the solution
  straight,  // squeezed straight to the chord, but for a bump one radius high: the saddle
};

Points start_nodes(Start start, Index edges) {
  const double l = length / static_cast<double>(edges);
  Points nodes(3, edges + 1);
  nodes.col(0).setZero();
  if (start == Start::arch) {
    double low = 0, high = 2.4048;  // the mean of cos(alpha sin s) is J0(alpha)
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (std::cyl_bessel_j(0.0, middle) > chord / length ? low : high) = middle;
    }
    for (Index j = 0; j < edges; ++j) {
      const double s = static_cast<double>(j) / static_cast<double>(edges);
      const double angle = low * std::sin(2 * pi * s);
      nodes.col(j + 1) = nodes.col(j) + l * Vec3(std::sin(angle), 0, std::cos(angle));
    }
  } else {
    for (Index i = 1; i < edges; ++i) {
      const double s = static_cast<double>(i - 1) / static_cast<double>(edges - 2);
      nodes.col(i) = Vec3((1 - std::cos(2 * pi * s)) / 2, 0, l + s * (chord - 2 * l));
    }
  }
  nodes.col(1) = Vec3(0, 0, l);
  nodes.col(edges - 1) = Vec3(0, 0, chord - l);
  nodes.col(edges) = Vec3(0, 0, chord);
  return nodes;
}

// Holding two nodes is holding the direction of the end edge; its rotation is held too. All other
// frames turn freely: the wire is three-dimensional, with twist.
HeldUnknowns held_ends(const RodState& rod) {
  HeldUnknowns held = HeldUnknowns::none(rod);
  const Index last = rod.node_count() - 1;
  for (const Index i : {Index{0}, Index{1}, last - 1, last}) held.hold_node(i);
  held.angle.front() = held.angle.back() = true;
  return held;
}

void buckled_rod(benchmark::State& bench, Start start) {
  const Index edges = bench.range(0);
  RodParams params;
  params.edge_length = length / static_cast<double>(edges);
  const RodState start_rod = make_rod(start_nodes(start, edges), params);
  const HeldUnknowns held = held_ends(start_rod);
  StretchEnergy stretch(params);
  JointEnergy joints(params);
  EnergyTerms energy{stretch, joints};
  const double bend = stiffness(params).bend;
  EquilibriumOptions options{};
  options.force_tolerance = tolerance * bend / (length * length);
  options.moment_tolerance = tolerance * bend / length;
  options.shift = options.method.shift * bend;

  EquilibriumReport report;
  RodState rod;
  for (auto _ : bench) {
    rod = start_rod;
    report = solve_equilibrium(rod, held, energy, options);
  }
  if (report.end != EquilibriumEnd::converged) bench.SkipWithError("has not converged");
  bench.counters["evaluations"] = static_cast<double>(report.work.evaluations);
  bench.counters["factorizations"] = static_cast<double>(report.work.factorizations);
  bench.counters["energy"] = report.energy;
  bench.counters["middle_height"] = rod.nodes(0, edges / 2);
  bench.counters["residual"] = report.residual * tolerance;
}

void sizes(benchmark::internal::Benchmark* bench) {
  bench->ArgName("edges")->Arg(200)->Arg(1000)->Arg(10000);
  bench->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(buckled_rod, arch, Start::arch)->Apply(sizes);
BENCHMARK_CAPTURE(buckled_rod, straight, Start::straight)->Apply(sizes);

}  // namespace
