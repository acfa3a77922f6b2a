#include "wirepack/dynamics/dynamic_state.hpp"

#include <cmath>
#include <string>

#include "wirepack/core/error.hpp"
#include "wirepack/core/rotation.hpp"

namespace wirepack {

DynamicState at_rest(RodState rod, double step) {
  DynamicState state;
  state.nodes = GearValues::Zero(rod.nodes.size(), 6);
  state.nodes.col(0) = rod.nodes.reshaped();
  state.spins = GearValues::Zero(static_cast<Index>(rod.frames.size()), 6);
  state.step = step;
  state.rod = std::move(rod);
  return state;
}

void set_velocities(DynamicState& state, const Points& velocity, const Eigen::VectorXd& spin_rate) {
  state.nodes.rightCols<5>().setZero();
  state.spins.rightCols<5>().setZero();
  state.nodes.col(1) = state.step * velocity.reshaped();
  state.spins.col(1) = state.step * spin_rate;
}

namespace {

// Angle by which parallel transport along the way of the tangent over the last step differs from
// that along the chord: the area between them, h^3 / 12 (t x t').t'' at the middle, from the
// derivatives of the edge there.
double holonomy_of_step(const DynamicState& state, Index node, Index next) {
  const auto derivative = [&](int k) -> Vec3 {
    return state.nodes.col(k).segment<3>(3 * next) - state.nodes.col(k).segment<3>(3 * node);
  };
  const Vec3 r1 = derivative(1), r2 = derivative(2), r3 = derivative(3);
  const Vec3 middle = derivative(0) - r1 / 2 + r2 / 4 - r3 / 8;
  const Vec3 rate = r1 - r2 + 0.75 * r3, change = 2 * r2 - 3 * r3;
  const double square = middle.squaredNorm();
  return middle.cross(rate).dot(change) / (12 * square * std::sqrt(square));
}

// Rotations up to a factor, without trigonometry or roots: a step turns an edge by little. The
// series of tan(angle / 2) misses by angle^7 / 8e4.
Quat turned_about(const Vec3& axis, double angle) {
  const double half = angle / 2, square = half * half;
  const double tangent = half * (1 + square * (1.0 / 3 + square * 2 / 15));
  return {1, tangent * axis.x(), tangent * axis.y(), tangent * axis.z()};
}
Quat carried_to(const Vec3& to, const Vec3& from) {
  const Vec3 v = from.cross(to);
  return {1 + from.dot(to), v.x(), v.y(), v.z()};
}

}  // namespace

void add_holonomy(DynamicState& state) {
  for (Index j = 0; j < state.rod.edge_count(); ++j) {
    state.spins(j, 0) += holonomy_of_step(state, j, next_node(state.rod, j));
  }
}

void follow_nodes(DynamicState& state) {
  RodState& rod = state.rod;
  rod.nodes.reshaped() = state.nodes.col(0);
  const Index edges = rod.edge_count();
  for (Index j = 0; j < edges; ++j) {
    const Vec3 e = rod.nodes.col(next_node(rod, j)) - rod.nodes.col(j);
    const double length = e.norm();
    if (!(length > 0)) {
      throw NumericalFailure("edge " + std::to_string(j) + " has no length, or is not finite");
    }
    const Vec3 t = e / length;
    Quat& frame = rod.frames[static_cast<std::size_t>(j)];
    frame = (turned_about(t, state.spins(j, 0)) * (carried_to(t, third_axis(frame)) * frame))
                .normalized();
  }
  for (auto k = static_cast<std::size_t>(edges); k < rod.frames.size(); ++k) {
    Quat& frame = rod.frames[k];
    frame = (turned_about(third_axis(frame), state.spins(static_cast<Index>(k), 0)) * frame)
                .normalized();
  }
  state.spins.col(0).setZero();
}

void set_motion(const DynamicState& state, WireMotion& motion) {
  const RodState& rod = state.rod;
  const Index edges = rod.edge_count();
  motion.velocity = (state.nodes.col(1) / state.step).reshaped(3, rod.node_count());
  motion.edge.resize(3, edges);
  motion.tangent.resize(3, edges);
  motion.length.resize(edges);
  motion.angular_velocity.resize(3, edges);
  for (Index j = 0; j < edges; ++j) {
    const Index next = next_node(rod, j);
    const Vec3 e = rod.nodes.col(next) - rod.nodes.col(j);
    const double length = e.norm();
    const Vec3 t = e / length;
    motion.edge.col(j) = e;
    motion.tangent.col(j) = t;
    motion.length[j] = length;
    motion.angular_velocity.col(j) =
        t.cross(motion.velocity.col(next) - motion.velocity.col(j)) / length +
        state.spin_rate(j) * t;
  }
}

}  // namespace wirepack
