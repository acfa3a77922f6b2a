#pragma once

#include <array>
#include <string_view>

#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// What the nodes of a frame can be coloured by.
struct NodeField {
  std::string_view name, label, unit;
  bool logarithmic;  ///< spans decades; zero where there is none
  Eigen::VectorXd (*of)(const Scenario& scenario, const PackingFrame& frame);  ///< N
};

/// Bend energy per length over YI / (2 R^2), which is (R kappa)^2 with the curvature kappa beyond
/// the rest shape's; twist energy per length, the same; contact and wall force per length over YI /
/// R^3; alignment (3 cos^2 - 1) / 2 of the coil about the node with the director of all coil axes,
/// 1 where they are parallel. Lengths are halves of the edges that meet at a node. A contact's
/// force counts for both strands, half for each end of the edges.
extern const std::array<NodeField, 5> node_fields;

}  // namespace wirepack
