#include "wirepack/rod/frame_chart.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "wirepack/core/rotation.hpp"
#include "wirepack/rod/rod_strain.hpp"

namespace wirepack {

HeldUnknowns HeldUnknowns::none(const RodState& state) {
  return {std::vector<bool>(static_cast<std::size_t>(3 * state.node_count()), false),
          std::vector<bool>(state.frames.size(), false)};
}

void HeldUnknowns::hold_node(Index node) {
  for (Index c = 0; c < 3; ++c) coordinate[static_cast<std::size_t>(3 * node + c)] = true;
}

FrameChart::FrameChart(RodState reference, const HeldUnknowns& held)
    : reference_(std::move(reference)), frames_follow_(held.frames_follow) {
  assert(held.frames_follow ||
         std::find(held.angle.begin(), held.angle.end(), false) == held.angle.end());
  for (Quat& frame : reference_.frames) frame.normalize();
  reference_.twist_guide = joint_twists(reference_);
  const Index n = reference_.node_count();
  number_.assign(static_cast<std::size_t>(4 * (n + 1)), -1);
  const auto take = [&](Index node, int slot, bool is_held) {
    if (!is_held) number_[static_cast<std::size_t>(4 * node + slot)] = size_++;
  };
  for (Index i = 0; i < n; ++i) {
    for (int c = 0; c < 3; ++c) {
      take(i, c, held.coordinate[static_cast<std::size_t>(3 * i + c)]);
      if (const Index u = unknown(i, c); u >= 0) places_.push_back({u, 3 * i + c});
    }
    if (i < reference_.edge_count()) {
      take(i, 3, held.angle[static_cast<std::size_t>(i)]);
    } else if (reference_.ends.last_clamped) {
      take(i, 3, held.angle[static_cast<std::size_t>(reference_.last_clamp_frame())]);
    }
  }
  if (reference_.ends.first_clamped) {
    take(n, 3, held.angle[static_cast<std::size_t>(reference_.first_clamp_frame())]);
  }
  reference_tangents_.resize(3, static_cast<Index>(reference_.frames.size()));
  for (Index j = 0; j < reference_tangents_.cols(); ++j) {
    reference_tangents_.col(j) = third_axis(reference_.frames[static_cast<std::size_t>(j)]);
  }
}

Index FrameChart::angle_block(Index frame) const {
  if (frame < reference_.edge_count()) return frame;
  const bool first = reference_.ends.first_clamped && frame == reference_.first_clamp_frame();
  return first ? reference_.node_count() : reference_.node_count() - 1;
}

Eigen::VectorXd FrameChart::unknowns() const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(size_);
  gather(reference_.nodes, x);
  return x;
}

void FrameChart::set_state(const Eigen::VectorXd& x, RodState& out,
                           std::span<const Quat> turns) const {
  const auto angle = [&](Index frame) {
    const Index u = unknown(angle_block(frame), 3);
    return u >= 0 ? x[u] : 0.0;
  };
  scatter(x, out.nodes);
  if (!frames_follow_) return;
  const Index edges = reference_.edge_count();
  for (Index j = 0; j < reference_tangents_.cols(); ++j) {
    Vec3 t0 = reference_tangents_.col(j);
    Quat frame = reference_.frames[static_cast<std::size_t>(j)];
    if (!turns.empty()) {
      t0 = turns[static_cast<std::size_t>(j)] * t0;
      frame = turns[static_cast<std::size_t>(j)] * frame;
    }
    const double theta = angle(j);
    if (theta != 0) frame = rotation_about(t0, theta) * frame;
    if (j < edges) {
      const Vec3 t = (out.nodes.col(next_node(out, j)) - out.nodes.col(j)).normalized();
      frame = transport(t0, t) * frame;
    }
    out.frames[static_cast<std::size_t>(j)] = frame;
  }
  // The angles give the change of twist but for the small part from transport, so whole turns are
  // followed however far a clamp is turned in one step.
  for_each_joint(out, [&](const Joint& joint) {
    const auto node = static_cast<std::size_t>(joint.node);
    out.twist_guide[node] = reference_.twist_guide[node] + angle(joint.after) - angle(joint.before);
  });
}

void FrameChart::pull_back(const RodState& state, const Points& by_node, const Points& by_frame,
                           Eigen::VectorXd& out, std::span<const Quat> turns) const {
  out.resize(size_);
  gather(by_node, out);
  if (!frames_follow_) return;
  const auto add_node = [&](Index i, const Vec3& force) {
    for (int c = 0; c < 3; ++c) {
      if (const Index u = unknown(i, c); u >= 0) out[u] += force[c];
    }
  };
  const Index edges = state.edge_count();
  for (Index j = 0; j < by_frame.cols(); ++j) {
    const Vec3 m = by_frame.col(j);
    Vec3 t0 = reference_tangents_.col(j);
    if (!turns.empty()) t0 = turns[static_cast<std::size_t>(j)] * t0;
    Vec3 t = t0;
    if (j < edges) {
      const Index next = next_node(state, j);
      const Vec3 e = state.nodes.col(next) - state.nodes.col(j);
      const double length = e.norm();
      t = e / length;
      const Vec3 by_edge = (m.cross(t) - m.dot(t) / (1 + t0.dot(t)) * t0.cross(t)) / length;
      add_node(next, by_edge);
      add_node(j, -by_edge);
    }
    if (const Index u = unknown(angle_block(j), 3); u >= 0) out[u] = m.dot(t);
  }
}

}  // namespace wirepack
