#include "node_values.hpp"

#include <algorithm>

namespace wirepack {

Eigen::VectorXd node_lengths(const RodState& rod) {
  Eigen::VectorXd lengths = Eigen::VectorXd::Zero(rod.node_count());
  for (Index j = 0; j < rod.edge_count(); ++j) {
    const double half = (rod.nodes.col(j + 1) - rod.nodes.col(j)).norm() / 2;
    lengths[j] += half;
    lengths[j + 1] += half;
  }
  return lengths;
}

Eigen::VectorXd contact_force(const PackingFrame& frame) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(frame.rod.node_count());
  for (const SelfContact& contact : frame.contacts) {
    for (const Index edge : {contact.edges.first, contact.edges.second}) {
      force[edge] += contact.force / 2;
      force[edge + 1] += contact.force / 2;
    }
  }
  return force;
}

Eigen::VectorXd scaled_bend_energy(const Scenario& scenario, const PackingFrame& frame) {
  const double unit = force_unit(scenario) / 2;
  return (frame.bend_energy.array() / (node_lengths(frame.rod).array() * unit)).matrix();
}

double top_of_colours(const Eigen::VectorXd& values) {
  std::vector<double> sorted(values.data(), values.data() + values.size());
  std::sort(sorted.begin(), sorted.end());
  const auto last = static_cast<double>(sorted.size() - 1);
  return std::max(1e-3, sorted[static_cast<std::size_t>(0.98 * last)]);
}

std::vector<NodeValue> node_values(const Scenario& scenario, const PackingFrame& frame) {
  Eigen::VectorXd arc = Eigen::VectorXd::Zero(frame.rod.node_count());
  for (Index i = 1; i < arc.size(); ++i) {
    arc[i] = arc[i - 1] + (frame.rod.nodes.col(i) - frame.rod.nodes.col(i - 1)).norm();
  }
  return {{"arc_length", "length", arc},
          {"bend_energy", "force length", frame.bend_energy},
          {"twist_energy", "force length", frame.twist_energy},
          {"scaled_bend_energy", "YI/2R^2", scaled_bend_energy(scenario, frame)},
          {"wall_force", "force", frame.wall_force},
          {"contact_force", "force", contact_force(frame)}};
}

}  // namespace wirepack
