#include "wirepack/energy/joint_energy.hpp"

#include <array>
#include <cmath>

#include "wirepack/core/lanes.hpp"
#include "wirepack/core/rotation.hpp"
#include "wirepack/rod/rest_strain.hpp"
#include "wirepack/rod/rod_strain.hpp"

namespace wirepack {

namespace {

Vec3 joint_stiffness(const Stiffness& s) { return {s.bend, s.bend, s.twist}; }

const Quat& frame(const RodState& state, Index index) {
  return state.frames[static_cast<std::size_t>(index)];
}

double guide(const RodState& state, Index node) {
  return state.twist_guide[static_cast<std::size_t>(node)];
}

}  // namespace

// Without torsion and rest curvature the bending energy is a function of the tangents alone:
// K / 2 |2 t x t' / (1 + t.t')|^2 = 2 K (1 - t.t') / (1 + t.t'), K = YI / l.
template <class T>
struct TangentBending {
  T energy;
  Triple<T> by_before, by_after;  // each normal to its tangent
};

template <class T>
TangentBending<T> tangent_bending(const Triple<T>& before, const Triple<T>& after, const T& k) {
  const T cosine = dot(before, after);
  const Triple<T> normal = cross(before, after);
  const T f = 1.0 / (1.0 + cosine);
  const T by_cosine = -4.0 * k * f * f;
  // the cross product keeps the digits that 1 - cosine loses
  return {2.0 * k * dot(normal, normal) * f * f, by_cosine * (after - cosine * before),
          by_cosine * (before - cosine * after)};
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

// Joints 1 ... n - 3, whose edges have the same rest length, four at a time; then all others.
double add_bending_of_tangents(const RodState& state, const RodParams& params, double stiffness,
                               Gradient& gradient) {
  using std::sqrt;
  double energy = 0;
  Index done = 1;
  const Lanes k(stiffness / params.edge_length);
  for (; done + lane_count <= state.node_count() - 2; done += lane_count) {
    const auto nodes = [&](Index shift) {
      return columns_of(state.nodes, [&](int lane) { return done + shift + lane; });
    };
    const Triple<Lanes> middle = nodes(0);
    const Triple<Lanes> e1 = middle - nodes(-1), e2 = nodes(1) - middle;
    const Lanes inverse1 = 1.0 / sqrt(dot(e1, e1)), inverse2 = 1.0 / sqrt(dot(e2, e2));
    const auto bending = tangent_bending(inverse1 * e1, inverse2 * e2, k);
    const Triple<Lanes> by_e1 = inverse1 * bending.by_before, by_e2 = inverse2 * bending.by_after;
    for (int i = 0; i < lane_count; ++i) {
      energy += bending.energy[static_cast<std::size_t>(i)];
      const Vec3 g1 = lane(by_e1, i), g2 = lane(by_e2, i);
      gradient.node.col(done + i - 1) -= g1;
      gradient.node.col(done + i) += g1 - g2;
      gradient.node.col(done + i + 1) += g2;
    }
  }
  for_each_joint(state, [&](const Joint& joint) {
    if (joint.node >= 1 && joint.node < done) return;
    energy += add_joint_of_tangents(state, params, stiffness, joint, gradient);
  });
  return energy;
}

JointEnergy::JointEnergy(const RodParams& params, const Stiffness& stiffness)
    : params_(params), stiffness_(joint_stiffness(stiffness)) {}

double JointEnergy::add_gradient(const RodState& state, Gradient& gradient) const {
  if (stiffness_.z() == 0 && is_straight(params_)) {
    return add_bending_of_tangents(state, params_, stiffness_.x(), gradient);
  }
  double energy = 0;
  for_each_joint(state, [&](const Joint& joint) {
    const Quat& before = frame(state, joint.before);
    const double length = node_length(state, params_, joint.node);
    const JointStrain strain =
        joint_strain_derivative(before, frame(state, joint.after), guide(state, joint.node));
    const Vec3 excess = strain.value - rest_strain(state, params_, joint.node);
    const Vec3 moment = stiffness_.cwiseProduct(excess) / length;
    const double joint_energy = moment.dot(excess) / 2;
    energy += joint_energy;
    const Vec3 spin_moment = before * (strain.by_spin.transpose() * moment);
    gradient.frame.col(joint.after) += spin_moment;
    gradient.frame.col(joint.before) -= spin_moment;
    // E = K (s - s0)^2 / (2 l): dE = -E / l dl - M . ds0
    gradient.inlet_length -= node_length_by_inlet(state, joint.node) * joint_energy / length +
                             moment.dot(rest_strain_by_inlet(state, params_, joint.node));
  });
  return energy;
}

void JointEnergy::add_curvature(const RodState& state, CurvatureModel& model) const {
  for_each_joint(state, [&](const Joint& joint) {
    const Quat& before = frame(state, joint.before);
    const double length = node_length(state, params_, joint.node);
    const JointStrain strain =
        joint_strain_derivative(before, frame(state, joint.after), guide(state, joint.node));
    for (int k = 0; k < 3; ++k) {
      if (stiffness_[k] == 0) continue;
      const Vec3 by_spin = before * Vec3(strain.by_spin.row(k));
      const std::array<CurvatureModel::FramePart, 2> parts{
          {{joint.after, by_spin}, {joint.before, -by_spin}}};
      model.add_square(stiffness_[k] / length, {}, parts);
    }
  });
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
