#include "wirepack/rod/rod_strain.hpp"

#include "wirepack/rod/joint_strain.hpp"

namespace wirepack {

Vec3 joint_strain(const Quat& before, const Quat& after, double twist_guide) {
  return vec3(joint_strain(quat_of(before), quat_of(after), twist_guide).value);
}

JointStrain joint_strain_derivative(const Quat& before, const Quat& after, double twist_guide) {
  const auto strain = joint_strain(quat_of(before), quat_of(after), twist_guide);
  JointStrain result;
  result.value = vec3(strain.value);
  result.by_spin.row(0) = vec3(strain.bend1_by_spin);
  result.by_spin.row(1) = vec3(strain.bend2_by_spin);
  result.by_spin.row(2) = vec3(strain.twist_by_spin);
  return result;
}

double edge_strain(const RodState& state, const RodParams& params, Index edge) {
  const Vec3 e = state.nodes.col(next_node(state, edge)) - state.nodes.col(edge);
  return e.norm() / rest_length(state, params, edge) - 1;
}

std::vector<double> joint_twists(const RodState& state) {
  std::vector<double> twists = state.twist_guide;
  for_each_joint(state, [&](const Joint& joint) {
    const auto node = static_cast<std::size_t>(joint.node);
    twists[node] =
        joint_strain(state.frames[static_cast<std::size_t>(joint.before)],
                     state.frames[static_cast<std::size_t>(joint.after)], state.twist_guide[node])
            .z();
  });
  return twists;
}

}  // namespace wirepack
