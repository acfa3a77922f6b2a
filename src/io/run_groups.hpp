#pragma once

#include <string>
#include <vector>

#include "wirepack/io/figure.hpp"
#include "wirepack/observe/sample.hpp"

namespace wirepack {

// What runs have come to at one packing density.
struct CurvePoint {
  double packing_density;
  Sample force, bend, twist;  // F R^2 / YI, E_bend R / YI, E_twist R / YI
};

// Runs of one scenario but for their seeds.
struct RunGroup {
  std::string label;
  std::vector<const FigureRun*> runs;
  // Rows of a single run; of several runs means at densities that two of them have at least.
  std::vector<CurvePoint> points;
};

// In the order in which their first runs come.
std::vector<RunGroup> run_groups(const std::vector<FigureRun>& runs);

}  // namespace wirepack
