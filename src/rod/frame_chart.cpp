#include "wirepack/rod/frame_chart.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "wirepack/core/lanes.hpp"
#include "wirepack/core/rotation.hpp"
#include "wirepack/rod/edge_directions.hpp"
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
      if (const Index u = unknown(i, c); u >= 0) {
        add_to_runs(u, 3 * i + c);
      } else {
        held_coordinates_.push_back(3 * i + c);
      }
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
    angle_number_.push_back(unknown(angle_block(j), 3));
  }
}

void FrameChart::add_to_runs(Index unknown, Index coordinate) {
  if (!runs_.empty()) {
    Run& run = runs_.back();
    if (run.unknown + run.count == unknown && run.coordinate + run.count == coordinate) {
      ++run.count;
      return;
    }
  }
  runs_.push_back({unknown, coordinate, 1});
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

void FrameChart::scatter_angles(const Eigen::VectorXd& by_unknown,
                                Eigen::VectorXd& by_frame) const {
  const auto frames = static_cast<Index>(angle_number_.size());
  by_frame.resize(frames);
  for (Index j = 0; j < frames; ++j) {
    const Index u = angle_unknown(j);
    by_frame[j] = u >= 0 ? by_unknown[u] : 0.0;
  }
}

void FrameChart::gather_angles(const Eigen::VectorXd& by_frame, Eigen::VectorXd& by_unknown) const {
  for (Index j = 0; j < by_frame.size(); ++j) {
    if (const Index u = angle_unknown(j); u >= 0) by_unknown[u] = by_frame[j];
  }
}

void FrameChart::set_state(const Eigen::VectorXd& x, RodState& out) const {
  scatter(x, out.nodes);
  if (!frames_follow_) return;
  Eigen::VectorXd angle;
  scatter_angles(x, angle);
  set_frames(start(), angle, out);
}

void FrameChart::set_frames(const Start& start, const Eigen::VectorXd& angle, RodState& out) const {
  const Index edges = reference_.edge_count();
  const Index frames = angle.size();
  const auto turned = [&]<class T>(Index j, const Triple<T>& t0) {
    return rotation_about(t0, load<T>(angle.data() + j)) * load_quats<T>(start.frames.data(), j);
  };
  for_each_edge_direction(out, [&]<class T>(Index j, const EdgeDirection<T>& edge) {
    const Triple<T> t0 = load_columns<T>(start.tangents, j);
    store_quats(transport(t0, edge.tangent) * turned(j, t0), out.frames.data(), j);
  });
  for (Index j = edges; j < frames; ++j) {
    store_quats(turned(j, load_columns<double>(start.tangents, j)), out.frames.data(), j);
  }
  // The angles give the change of twist but for the small part from transport, so whole turns are
  // followed however far a clamp is turned in one step.
  for_each_joint(out, [&](const Joint& joint) {
    const auto node = static_cast<std::size_t>(joint.node);
    out.twist_guide[node] = reference_.twist_guide[node] + angle[joint.after] - angle[joint.before];
  });
}

void FrameChart::pull_back(const RodState& state, const Points& by_node, const Points& by_frame,
                           Eigen::VectorXd& out) const {
  out.resize(size_);
  if (!frames_follow_) {
    gather(by_node, out);
    return;
  }
  Points by_nodes = by_node;
  Eigen::VectorXd by_angle;
  pull_back_frames(start(), state, by_frame, by_nodes, by_angle);
  gather(by_nodes, out);
  gather_angles(by_angle, out);
}

void FrameChart::pull_back_frames(const Start& start, const RodState& state, const Points& by_frame,
                                  Points& by_node, Eigen::VectorXd& by_angle) const {
  const Index edges = state.edge_count();
  const Index frames = by_frame.cols();
  Points by_edge(3, edges);
  by_angle.resize(frames);
  for_each_edge_direction(state, [&]<class T>(Index j, const EdgeDirection<T>& edge) {
    const Triple<T> m = load_columns<T>(by_frame, j);
    const Triple<T> t0 = load_columns<T>(start.tangents, j), t = edge.tangent;
    const T spin = dot(m, t);
    store(spin, by_angle.data() + j);
    store_columns((1.0 / edge.length) * (cross(m, t) - (spin / (1.0 + dot(t0, t))) * cross(t0, t)),
                  by_edge, j);
  });
  for (Index j = edges; j < frames; ++j) {
    by_angle[j] = dot(load_columns<double>(by_frame, j), load_columns<double>(start.tangents, j));
  }
  add_by_edges(state, by_edge, by_node);
}

}  // namespace wirepack
