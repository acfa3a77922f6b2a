#include <array>

#include "wirepack/core/lane_differences.hpp"
#include "wirepack/core/rotation.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/rod/rest_strain.hpp"
#include "wirepack/rod/rod_strain.hpp"

#include "joint_gradient.hpp"

namespace wirepack {

namespace {

// Of the edge vectors over their lengths, and of the angles: rounding 1e-11, and as much curvature
// of the second derivative.
constexpr double difference = 1e-5;

template <class T>
Triple<T> triple_of(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

template <class T>
QuatOf<T> quat_of(const Quat& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

// A frame that follows its edge e and turns about it by an angle, as in a FrameChart.
template <class T>
struct EdgeFrame {
  QuatOf<T> frame;
  Triple<T> reference_tangent, tangent;
  T inverse_length;

  EdgeFrame(const Quat& reference, const Triple<T>& e, const T& angle) {
    using std::sqrt;
    reference_tangent = triple_of<T>(third_axis(reference));
    inverse_length = 1.0 / sqrt(dot(e, e));
    tangent = inverse_length * e;
    frame = transport(reference_tangent, tangent) *
            (rotation_about(reference_tangent, angle) * quat_of<T>(reference));
  }
  Triple<T> by_edge(const Triple<T>& by_spin) const {
    const T twist = dot(by_spin, tangent) / (1.0 + dot(reference_tangent, tangent));
    return inverse_length * (cross(by_spin, tangent) - twist * cross(reference_tangent, tangent));
  }
};

using ByEdges = Eigen::Matrix<double, 8, 8>;  // edge before and its angle, edge after and its angle

// A clamp is an edge of length 1.
Vec3 edge_or_tangent(const RodState& state, Index index) {
  if (index >= state.edge_count()) return third_axis(frame(state, index));
  return state.nodes.col(next_node(state, index)) - state.nodes.col(index);
}

template <class Gradient>
ByEdges second_derivative_by_edges(const RodState& state, const Joint& joint, Gradient&& gradient) {
  const Vec3 e1 = edge_or_tangent(state, joint.before), e2 = edge_or_tangent(state, joint.after);
  const double scale1 = 1 / e1.norm(), scale2 = 1 / e2.norm();
  const Vec3 t1 = scale1 * e1, t2 = scale2 * e2;
  // bending and twist depend on tangents and angles only
  const ByEdges by_tangents = second_derivative<8>(
      {t1.x(), t1.y(), t1.z(), 0, t2.x(), t2.y(), t2.z(), 0}, difference, gradient);
  const Eigen::Vector<double, 8> scale{scale1, scale1, scale1, 1, scale2, scale2, scale2, 1};
  return scale.asDiagonal() * by_tangents * scale.asDiagonal();
}

// From edges and angles to the blocks of the chart.
void add_by_edges(const ByEdges& by_edges, const RodState& state, const Joint& joint,
                  CurvatureModel& model) {
  std::array<Index, 4> blocks;
  std::size_t count = 0;
  Eigen::Matrix<double, 16, 8> by_block = Eigen::Matrix<double, 16, 8>::Zero();
  const auto row = [&](Index block) {
    std::size_t k = 0;
    while (k < count && blocks[k] != block) ++k;
    if (k == count) blocks[count++] = block;
    return 4 * static_cast<Index>(k);
  };
  const auto add = [&](Index index, Index column) {
    if (index < state.edge_count()) {
      by_block.block<3, 3>(row(next_node(state, index)), column) += Mat3::Identity();
      by_block.block<3, 3>(row(index), column) -= Mat3::Identity();
    }
    by_block(row(model.chart().angle_block(index)) + 3, column + 3) = 1;
  };
  add(joint.before, 0);
  add(joint.after, 4);
  const auto used = by_block.topRows(4 * static_cast<Index>(count));
  model.add_hessian(model.exactness(), used * by_edges * used.transpose(),
                    std::span(blocks).first(count));
}

}  // namespace

void JointEnergy::add_curvature(const RodState& state, CurvatureModel& model) const {
  for_each_joint(state, [&](const Joint& joint) {
    const Quat& before = frame(state, joint.before);
    const Quat& after = frame(state, joint.after);
    const double guide = state.twist_guide[static_cast<std::size_t>(joint.node)];
    const double length = node_length(state, params_, joint.node);
    const JointStrain strain = joint_strain_derivative(before, after, guide);
    for (int k = 0; k < 3; ++k) {
      if (stiffness_[k] == 0) continue;
      const Vec3 by_spin = before * Vec3(strain.by_spin.row(k));
      const std::array<CurvatureModel::FramePart, 2> parts{
          {{joint.after, by_spin}, {joint.before, -by_spin}}};
      model.add_square((1 - model.exactness()) * stiffness_[k] / length, {}, parts);
    }
    if (model.exactness() == 0) return;
    using Unknowns = std::array<Lanes, 8>;
    if (of_tangents_alone()) {
      const auto gradient = [&](const Unknowns& x) -> Unknowns {
        using std::sqrt;
        const Triple<Lanes> e1{x[0], x[1], x[2]}, e2{x[4], x[5], x[6]};
        const Lanes inverse1 = 1.0 / sqrt(dot(e1, e1)), inverse2 = 1.0 / sqrt(dot(e2, e2));
        const auto bending =
            tangent_bending(inverse1 * e1, inverse2 * e2, Lanes(stiffness_.x() / length));
        const Triple<Lanes> g1 = inverse1 * bending.by_before, g2 = inverse2 * bending.by_after;
        return {g1.x, g1.y, g1.z, 0.0, g2.x, g2.y, g2.z, 0.0};
      };
      add_by_edges(second_derivative_by_edges(state, joint, gradient), state, joint, model);
      return;
    }
    const Triple<Lanes> rest = triple_of<Lanes>(rest_strain(state, params_, joint.node));
    const auto gradient = [&](const Unknowns& x) -> Unknowns {
      const EdgeFrame<Lanes> first(before, {x[0], x[1], x[2]}, x[3]);
      const EdgeFrame<Lanes> second(after, {x[4], x[5], x[6]}, x[7]);
      const Triple<Lanes> spin =
          joint_gradient(first.frame, second.frame, Lanes(guide), rest, stiffness_, length).by_spin;
      const Triple<Lanes> g1 = first.by_edge(Lanes(-1.0) * spin), g2 = second.by_edge(spin);
      return {g1.x, g1.y, g1.z, -dot(spin, first.tangent),
              g2.x, g2.y, g2.z, dot(spin, second.tangent)};
    };
    add_by_edges(second_derivative_by_edges(state, joint, gradient), state, joint, model);
  });
}

}  // namespace wirepack
