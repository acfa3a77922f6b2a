#include "wirepack/rod/rod_strain.hpp"

#include <cmath>

#include "wirepack/core/rotation.hpp"

namespace wirepack {

namespace {

/// p = conj(before) after and its twist. p and -p are the same rotation; the sign is the one whose
/// twist 2 atan2(z, w), up to full cycles of 4 pi, is within pi of the guide, so that the half-way
/// frame in which bending is measured turns continuously with the twist.
struct RelativeFrame {
  double w, x, y, z, twist;
};

RelativeFrame relative_frame(const Quat& before, const Quat& after, double twist_guide) {
  const Quat p = before.conjugate() * after;
  const double raw = 2 * std::atan2(p.z(), p.w());
  const double turns = std::round((twist_guide - raw) / (2 * pi));
  const double sign = std::fmod(turns, 2.0) == 0 ? 1 : -1;
  return {sign * p.w(), sign * p.x(), sign * p.y(), sign * p.z(), raw + 2 * pi * turns};
}

}  // namespace

Vec3 joint_strain(const Quat& before, const Quat& after, double twist_guide) {
  const RelativeFrame p = relative_frame(before, after, twist_guide);
  const double scale = 2 / std::sqrt(p.w * p.w + p.z * p.z);
  return {scale * p.x, scale * p.y, p.twist};
}

JointStrain joint_strain_derivative(const Quat& before, const Quat& after, double twist_guide) {
  const RelativeFrame p = relative_frame(before, after, twist_guide);
  const double inverse_c2 = 1 / (p.w * p.w + p.z * p.z);
  const double scale = 2 * std::sqrt(inverse_c2);

  // dp = 1/2 (0, spin) p, spin in the frame `before`
  const Vec3 dw = -0.5 * Vec3(p.x, p.y, p.z);
  const Vec3 dx = 0.5 * Vec3(p.w, p.z, -p.y);
  const Vec3 dy = 0.5 * Vec3(-p.z, p.w, p.x);
  const Vec3 dz = 0.5 * Vec3(p.y, -p.x, p.w);
  const Vec3 half_dlog_c2 = (p.w * dw + p.z * dz) * inverse_c2;

  JointStrain result;
  result.value = Vec3(scale * p.x, scale * p.y, p.twist);
  result.by_spin.row(0) = scale * (dx - p.x * half_dlog_c2);
  result.by_spin.row(1) = scale * (dy - p.y * half_dlog_c2);
  result.by_spin.row(2) = 2 * inverse_c2 * (p.w * dz - p.z * dw);
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
