#include "node_fields.hpp"

#include <algorithm>

#include "wirepack/observe/order.hpp"

#include "node_values.hpp"

namespace wirepack {

namespace {

Eigen::VectorXd per_length(const PackingFrame& frame, const Eigen::VectorXd& values, double unit) {
  return (values.array() / (node_lengths(frame.rod).array() * unit)).matrix();
}

double force_line_unit(const Scenario& s) { return force_unit(s) / s.cavity.radius; }

Eigen::VectorXd twist_energy(const Scenario& scenario, const PackingFrame& frame) {
  return per_length(frame, frame.twist_energy, force_unit(scenario) / 2);
}

Eigen::VectorXd contact_force_line(const Scenario& scenario, const PackingFrame& frame) {
  return per_length(frame, contact_force(frame), force_line_unit(scenario));
}

Eigen::VectorXd wall_force(const Scenario& scenario, const PackingFrame& frame) {
  return per_length(frame, frame.wall_force, force_line_unit(scenario));
}

Eigen::VectorXd coil_alignment(const Scenario&, const PackingFrame& frame) {
  const Index n = frame.rod.node_count();
  const Points axes = coil_axes(frame.rod);
  if (axes.cols() == 0) return Eigen::VectorXd::Zero(n);
  const Vec3 director = axial_order(axes).director;
  // An axis is that of the turn which begins at its node; its middle is half a turn further.
  const Index half_turn = (n - axes.cols()) / 2;
  Eigen::VectorXd result(n);
  for (Index i = 0; i < n; ++i) {
    const Index k = std::clamp<Index>(i - half_turn, 0, axes.cols() - 1);
    const double cosine = axes.col(k).dot(director);
    result[i] = (3 * cosine * cosine - 1) / 2;
  }
  return result;
}

}  // namespace

const std::array<NodeField, 5> node_fields{{
    {"bend_energy", "bending energy per length", "YI/2R²", true, scaled_bend_energy},
    {"twist_energy", "torsion energy per length", "YI/2R²", true, twist_energy},
    {"contact_force", "contact force per length", "YI/R³", true, contact_force_line},
    {"wall_force", "wall force per length", "YI/R³", true, wall_force},
    {"coil_alignment", "order: alignment of the coil axis", "1", false, coil_alignment},
}};

}  // namespace wirepack
