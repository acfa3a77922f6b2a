#include "wirepack/dynamics/dynamic_state.hpp"

#include <cmath>
#include <string>

#include "wirepack/core/error.hpp"
#include "wirepack/core/lanes.hpp"
#include "wirepack/core/rotation.hpp"
#include "wirepack/rod/edge_directions.hpp"

namespace wirepack {

DynamicState without_velocity(RodState rod, double step) {
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
template <class T>
QuatOf<T> turned_about(const Triple<T>& axis, const T& angle) {
  const T half = 0.5 * angle, square = half * half;
  const Triple<T> v = (half * (1.0 + square * (1.0 / 3 + square * (2.0 / 15)))) * axis;
  return {1.0, v.x, v.y, v.z};
}
template <class T>
QuatOf<T> carried_to(const Triple<T>& to, const Triple<T>& from) {
  const Triple<T> v = cross(from, to);
  return {1.0 + dot(from, to), v.x, v.y, v.z};
}
template <class T>
QuatOf<T> normalized(const QuatOf<T>& q) {
  using std::sqrt;
  const T factor = 1.0 / sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {factor * q.w, factor * q.x, factor * q.y, factor * q.z};
}

[[noreturn]] void name_edge_without_length(const RodState& rod) {
  const auto has_length = [&](Index edge) {
    return (rod.nodes.col(next_node(rod, edge)) - rod.nodes.col(edge)).norm() > 0;
  };
  Index edge = 0;
  while (edge + 1 < rod.edge_count() && has_length(edge)) ++edge;
  throw NumericalFailure("edge " + std::to_string(edge) + " has no length, or is not finite");
}

bool all_positive(double length) { return length > 0; }
bool all_positive(const Lanes& lengths) { return all_of(lengths > 0.0); }

}  // namespace

void add_holonomy(DynamicState& state) {
  for (Index j = 0; j < state.rod.edge_count(); ++j) {
    state.spins(j, 0) += holonomy_of_step(state, j, next_node(state.rod, j));
  }
}

void follow_nodes(DynamicState& state) {
  RodState& rod = state.rod;
  rod.nodes.reshaped() = state.nodes.col(0);
  bool positive = true;
  const auto turn = [&]<class T>(Index j, const Triple<T>& tangent, const QuatOf<T>& carried) {
    const T angle = load<T>(state.spins.data() + j);
    store_quats(normalized(turned_about(tangent, angle) * carried), rod.frames.data(), j);
  };
  for_each_edge_direction(rod, [&]<class T>(Index j, const EdgeDirection<T>& edge) {
    positive = positive && all_positive(edge.length);
    const QuatOf<T> frame = load_quats<T>(rod.frames.data(), j);
    turn(j, edge.tangent, carried_to(edge.tangent, third_axis(frame)) * frame);
  });
  if (!positive) name_edge_without_length(rod);
  const auto frames = static_cast<Index>(rod.frames.size());
  for (Index k = rod.edge_count(); k < frames; ++k) {
    const QuatOf<double> frame = load_quats<double>(rod.frames.data(), k);
    turn(k, third_axis(frame), frame);
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
  for_each_edge_direction(rod, [&]<class T>(Index j, const EdgeDirection<T>& edge) {
    const Triple<T>& t = edge.tangent;
    const Index next = next_node(rod, j);
    const Triple<T> apart =
        load_columns<T>(motion.velocity, next) - load_columns<T>(motion.velocity, j);
    const T spin_rate = load<T>(state.spins.col(1).data() + j) / T(state.step);
    store_columns(edge.length * t, motion.edge, j);
    store_columns(t, motion.tangent, j);
    store(edge.length, motion.length.data() + j);
    store_columns((1.0 / edge.length) * cross(t, apart) + spin_rate * t, motion.angular_velocity,
                  j);
  });
}

}  // namespace wirepack
