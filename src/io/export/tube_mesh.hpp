#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// A closed surface of triangles that face outwards.
struct TubeMesh {
  Points points;
  Eigen::VectorXd scaled_bend_energy;  ///< at the points
  std::vector<std::array<std::int32_t, 3>> triangles;
};

/// The surface of the wire, along the smooth centreline of the packing figure, with flat ends.
/// Cross-sections are polygons of the wire's own area, so the volume is right.
TubeMesh tube_mesh(const Scenario& scenario, const PackingFrame& frame);

}  // namespace wirepack
