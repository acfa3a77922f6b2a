#include "wirepack/energy/joint_energy.hpp"

#include <array>

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

JointEnergy::JointEnergy(const RodParams& params, const Stiffness& stiffness)
    : params_(params), stiffness_(joint_stiffness(stiffness)) {}

double JointEnergy::add_gradient(const RodState& state, Gradient& gradient) const {
  double energy = 0;
  for_each_joint(state, [&](const Joint& joint) {
    const Quat& before = frame(state, joint.before);
    const double length = node_length(state, params_, joint.node);
    const JointStrain strain =
        joint_strain_derivative(before, frame(state, joint.after), guide(state, joint.node));
    const Vec3 excess = strain.value - length * params_.rest_darboux;
    const Vec3 moment = stiffness_.cwiseProduct(excess) / length;
    const double joint_energy = moment.dot(excess) / 2;
    energy += joint_energy;
    const Vec3 spin_moment = before * (strain.by_spin.transpose() * moment);
    gradient.frame.col(joint.after) += spin_moment;
    gradient.frame.col(joint.before) -= spin_moment;
    // E = K (s - l k0)^2 / (2 l): dE/dl = -E / l - M . k0
    gradient.inlet_length -= node_length_by_inlet(state, joint.node) *
                             (joint_energy / length + moment.dot(params_.rest_darboux));
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
                        length * params.rest_darboux;
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
