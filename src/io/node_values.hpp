#pragma once

#include <string>
#include <vector>

#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// A number at every node of a frame; units are powers of the base units of the configuration.
struct NodeValue {
  std::string name, unit;
  Eigen::VectorXd values;  ///< N
};

/// Length of wire that belongs to every node (N): half of both edges at the node.
Eigen::VectorXd node_lengths(const RodState& rod);

/// Force of self-contact at every node (N): half of each contact's force at either node of both
/// edges, so it sums up to twice the forces of the contacts.
Eigen::VectorXd contact_force(const PackingFrame& frame);

/// Bending energy per length over YI / (2 R^2) at every node (N): (kappa R)^2 of a wire that is
/// straight at rest.
Eigen::VectorXd scaled_bend_energy(const Scenario& scenario, const PackingFrame& frame);

/// Upper end of a range of colours: leaves out the largest 2 % of the values; at least 0.001.
double top_of_colours(const Eigen::VectorXd& values);

/// What formats with numbers at nodes hold: arc_length from the tip, bend_energy, twist_energy,
/// scaled_bend_energy, wall_force and contact_force.
std::vector<NodeValue> node_values(const Scenario& scenario, const PackingFrame& frame);

}  // namespace wirepack
