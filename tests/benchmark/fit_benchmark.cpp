// Fits of shapes to 10,000 points of a helix, starting values and errors included.
#include <benchmark/benchmark.h>

#include "wirepack/fit/shape_fit.hpp"

#include "../support/measured_wires.hpp"

namespace {

using namespace wirepack;

void fit(benchmark::State& bench, ShapeModel model, bool ordered) {
  Random random(1);
  const Points exact = testing::helix_points(10000, 1, 0.2, 8, true, 3);
  MeasuredPoints points =
      testing::measured(exact + testing::normal_noise(exact.cols(), 0.01, random));
  if (!ordered) points = testing::shuffled(points, 2);
  for (auto _ : bench) benchmark::DoNotOptimize(fit_shape(points, {model, false, {}}));
}

BENCHMARK_CAPTURE(fit, helix, ShapeModel::helix, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fit, helix_in_no_order, ShapeModel::helix, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fit, spline, ShapeModel::spline, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fit, spline_in_no_order, ShapeModel::spline, false)
    ->Unit(benchmark::kMillisecond);

}  // namespace
