#include "wirepack/rod/rod_state.hpp"

#include <string>

#include "wirepack/core/error.hpp"
#include "wirepack/core/rotation.hpp"

namespace wirepack {

namespace {

Vec3 edge_tangent(const RodState& state, Index edge) {
  const Vec3 e = state.nodes.col(next_node(state, edge)) - state.nodes.col(edge);
  const double length = e.norm();
  if (!(length > 0)) {
    throw NumericalFailure("edge " + std::to_string(edge) + " has no length");
  }
  return e / length;
}

}  // namespace

void add_by_edges(const RodState& state, const Points& by_edge, Points& by_node) {
  const Index last = state.node_count() - 1;
  by_node.leftCols(last) -= by_edge.leftCols(last);
  by_node.rightCols(last) += by_edge.leftCols(last);
  if (!state.ends.closed) return;
  by_node.col(last) -= by_edge.col(last);
  by_node.col(0) += by_edge.col(last);
}

double total_rest_length(const RodState& state, const RodParams& params) {
  const auto edges = static_cast<double>(state.edge_count());
  return (edges - 1) * params.edge_length + state.inlet_rest_length;
}

RodState make_rod(const Points& nodes, const RodParams& params, RodEnds ends) {
  RodState state;
  state.ends = ends;
  state.nodes = nodes;
  state.inlet_rest_length = params.edge_length;
  state.twist_guide.assign(static_cast<std::size_t>(nodes.cols()), 0.0);
  Quat frame = frame_with_tangent(edge_tangent(state, 0));
  for (Index j = 0; j < state.edge_count(); ++j) {
    const Vec3 tangent = edge_tangent(state, j);
    const Vec3 previous = third_axis(frame);
    if (previous.dot(tangent) < -0.9999) {
      throw NumericalFailure("the rod turns back on itself at node " + std::to_string(j));
    }
    frame = (transport(previous, tangent) * frame).normalized();
    state.frames.push_back(frame);
  }
  if (ends.first_clamped) state.frames.push_back(state.frames.front());
  if (ends.last_clamped) {
    state.frames.push_back(state.frames[static_cast<std::size_t>(state.edge_count() - 1)]);
  }
  return state;
}

void remove_twist(RodState& state) {
  const auto last = static_cast<std::size_t>(state.ends.last_clamped ? state.last_clamp_frame()
                                                                     : state.edge_count() - 1);
  Quat frame = state.frames[last];
  for (Index j = state.edge_count(); j-- > 0;) {
    frame = (transport(third_axis(frame), edge_tangent(state, j)) * frame).normalized();
    state.frames[static_cast<std::size_t>(j)] = frame;
  }
  if (state.ends.first_clamped) {
    Quat& clamp = state.frames[static_cast<std::size_t>(state.first_clamp_frame())];
    clamp = (transport(third_axis(frame), third_axis(clamp)) * frame).normalized();
  }
  state.twist_guide.assign(state.twist_guide.size(), 0.0);
}

void carry_frames(RodState& state) {
  for (Index j = 0; j < state.edge_count(); ++j) {
    Quat& frame = state.frames[static_cast<std::size_t>(j)];
    frame = (transport(third_axis(frame), edge_tangent(state, j)) * frame).normalized();
  }
}

void check_state(const RodState& state) {
  if (!state.nodes.allFinite()) throw NumericalFailure("a node position is not finite");
  for (Index j = 0; j < state.edge_count(); ++j) {
    const double off =
        (third_axis(state.frames[static_cast<std::size_t>(j)]) - edge_tangent(state, j)).norm();
    if (!(off < 1e-8)) {
      throw NumericalFailure("the frame of edge " + std::to_string(j) + " is off its tangent by " +
                             std::to_string(off));
    }
  }
}

}  // namespace wirepack
