#include "wirepack/energy/joint_energy.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "wirepack/core/lanes.hpp"
#include "wirepack/core/rotation.hpp"
#include "wirepack/rod/rest_strain.hpp"
#include "wirepack/rod/rod_strain.hpp"

#include "joint_gradient.hpp"

namespace wirepack {

namespace {

Vec3 joint_stiffness(const Stiffness& s) { return {s.bend, s.bend, s.twist}; }

double guide(const RodState& state, Index node) {
  return state.twist_guide[static_cast<std::size_t>(node)];
}

struct Tangent {
  Triple<double> direction;
  double inverse_length;
};

Tangent tangent_of(const RodState& state, Index index) {
  if (index >= state.edge_count()) return {triple(third_axis(frame(state, index))), 0};
  const Vec3 e = state.nodes.col(next_node(state, index)) - state.nodes.col(index);
  const double inverse_length = 1 / e.norm();
  return {triple(inverse_length * e), inverse_length};
}

void add_by_tangent(const RodState& state, Index index, const Tangent& tangent,
                    const Triple<double>& by_tangent, Gradient& gradient) {
  if (index >= state.edge_count()) {
    gradient.frame.col(index) += vec3(cross(tangent.direction, by_tangent));
    return;
  }
  const Vec3 by_edge = vec3(tangent.inverse_length * by_tangent);
  gradient.node.col(next_node(state, index)) += by_edge;
  gradient.node.col(index) -= by_edge;
}

double add_joint_of_tangents(const RodState& state, const RodParams& params, double stiffness,
                             const Joint& joint, Gradient& gradient) {
  const double length = node_length(state, params, joint.node);
  const Tangent before = tangent_of(state, joint.before), after = tangent_of(state, joint.after);
  const auto bending = tangent_bending(before.direction, after.direction, stiffness / length);
  add_by_tangent(state, joint.before, before, bending.by_before, gradient);
  add_by_tangent(state, joint.after, after, bending.by_after, gradient);
  gradient.inlet_length -= node_length_by_inlet(state, joint.node) * bending.energy / length;
  return bending.energy;
}

// Calls f for the joints that are not computed in lanes. Those in lanes are the inner joints
// 1 ... n - 3, which do not touch the inlet edge, so that they all have the same node length.
template <class F>
void for_each_other_joint(const RodState& state, F&& f) {
  for_each_joint(state, [&](const Joint& joint) {
    if (joint.node < 1 || joint.node + 2 >= state.node_count()) f(joint);
  });
}

Energy add_bending_of_tangents(const RodState& state, const RodParams& params, double stiffness,
                               Gradient& gradient) {
  EnergySum energy;
  const Index inner = std::max<Index>(0, state.node_count() - 3);
  Points by_before(3, inner), by_after(3, inner);
  for_each_in_lanes(0, inner, [&]<class T>(Index j) {
    using std::sqrt;
    const Triple<T> middle = load_columns<T>(state.nodes, j + 1);
    const Triple<T> e1 = middle - load_columns<T>(state.nodes, j);
    const Triple<T> e2 = load_columns<T>(state.nodes, j + 2) - middle;
    const T inverse1 = 1.0 / sqrt(dot(e1, e1)), inverse2 = 1.0 / sqrt(dot(e2, e2));
    const auto bending =
        tangent_bending(inverse1 * e1, inverse2 * e2, T(stiffness / params.edge_length));
    energy.add(bending.energy);
    store_columns(inverse1 * bending.by_before, by_before, j);
    store_columns(inverse2 * bending.by_after, by_after, j);
  });
  gradient.node.leftCols(inner) -= by_before;
  gradient.node.middleCols(1, inner) += by_before - by_after;
  gradient.node.middleCols(2, inner) += by_after;
  for_each_other_joint(state, [&](const Joint& joint) {
    energy.add(add_joint_of_tangents(state, params, stiffness, joint, gradient));
  });
  return energy.total();
}

}  // namespace

JointEnergy::JointEnergy(const RodParams& params, const Stiffness& stiffness)
    : params_(params), stiffness_(joint_stiffness(stiffness)) {}

bool JointEnergy::of_tangents_alone() const { return stiffness_.z() == 0 && is_straight(params_); }

Energy JointEnergy::add_gradient(const RodState& state, Gradient& gradient) const {
  if (of_tangents_alone()) {
    return add_bending_of_tangents(state, params_, stiffness_.x(), gradient);
  }
  EnergySum energy;
  const Index inner = std::max<Index>(0, state.node_count() - 3);
  Points rest(3, inner), by_spin(3, inner);
  const bool uniform = params_.reference_shape.empty();
  for (Index j = 0; j < inner; ++j) {
    rest.col(j) = uniform && j > 0 ? Vec3(rest.col(0)) : rest_strain(state, params_, j + 1);
  }
  for_each_in_lanes(0, inner, [&]<class T>(Index j) {
    const auto joint = joint_gradient(load_quats<T>(state.frames.data(), j),
                                      load_quats<T>(state.frames.data(), j + 1),
                                      load<T>(state.twist_guide.data() + j + 1),
                                      load_columns<T>(rest, j), stiffness_, params_.edge_length);
    energy.add(joint.energy);
    store_columns(joint.by_spin, by_spin, j);
  });
  gradient.frame.leftCols(inner) -= by_spin;
  gradient.frame.middleCols(1, inner) += by_spin;
  for_each_other_joint(state, [&](const Joint& j) {
    const double length = node_length(state, params_, j.node);
    const auto joint = joint_gradient(
        quat_of(frame(state, j.before)), quat_of(frame(state, j.after)), guide(state, j.node),
        triple(rest_strain(state, params_, j.node)), stiffness_, length);
    energy.add(joint.energy);
    gradient.frame.col(j.after) += vec3(joint.by_spin);
    gradient.frame.col(j.before) -= vec3(joint.by_spin);
    // E = K (s - s0)^2 / (2 l): dE = -E / l dl - M . ds0
    gradient.inlet_length -= node_length_by_inlet(state, j.node) * joint.energy / length +
                             vec3(joint.moment).dot(rest_strain_by_inlet(state, params_, j.node));
  });
  return energy.total();
}

NodeEnergies node_energies(const RodParams& params, const RodState& state) {
  const Vec3 stiff = joint_stiffness(stiffness(params));
  NodeEnergies energies{Eigen::VectorXd::Zero(state.node_count()),
                        Eigen::VectorXd::Zero(state.node_count())};
  for_each_joint(state, [&](const Joint& joint) {
    const double length = node_length(state, params, joint.node);
    const Vec3 excess = joint_strain(frame(state, joint.before), frame(state, joint.after),
                                     guide(state, joint.node)) -
                        rest_strain(state, params, joint.node);
    const Vec3 energy = stiff.cwiseProduct(excess.cwiseAbs2()) / (2 * length);
    energies.bend[joint.node] = energy.x() + energy.y();
    energies.twist[joint.node] = energy.z();
  });
  return energies;
}

JointEnergies joint_energies(const RodParams& params, const RodState& state) {
  const NodeEnergies energies = node_energies(params, state);
  return {energies.bend.sum(), energies.twist.sum()};
}

}  // namespace wirepack
