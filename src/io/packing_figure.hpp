#pragma once

#include <string>
#include <vector>

#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/scenario.hpp"

#include "gnuplot.hpp"

namespace wirepack {

// A moment of a run to be drawn, and the words above it.
struct ShownPacking {
  const Scenario* scenario;
  const PackingFrame* frame;
  std::string caption;
};

// "high torsion, R = 10 a, phi = 0.200".
std::string packing_caption(const Scenario& scenario, const PackingFrame& frame);

// Upper end of the colours with which a frame is drawn: bending energy per length over YI/2R^2.
double top_of_colours(const Scenario& scenario, const PackingFrame& frame);

// The figure `packing` of one run, outside and cut side by side, or of two, one beside the other.
// Each fits its own cavity; colours end at `top`; `width` are the pixels of one view.
Drawing packing_drawing(const std::vector<ShownPacking>& shown, double top, int width);

}  // namespace wirepack
