#pragma once

#include <vector>

#include "wirepack/core/types.hpp"
#include "wirepack/rod/rod_params.hpp"

namespace wirepack {

/// How the ends of the wire are joined. A clamp is a frame of its own beyond the end: the joint
/// between it and the end edge carries bending and twist over half the rest length of that edge.
/// A pinned end is a free end whose node is held.
struct RodEnds {
  bool closed = false;  ///< last node joined to the first by one more edge
  bool first_clamped = false;
  bool last_clamped = false;
};

/// Configuration of one wire: plain data. Edge j joins nodes j and j + 1 (mod N when closed), so
/// tangents point from node 0 (the tip, which entered first) to the nozzle. Frames are adapted:
/// the third axis of frame j is the tangent of edge j. After the E edge frames come the frame of
/// the first clamp and that of the last clamp, where there are any.
struct RodState {
  RodEnds ends;
  Points nodes;                     ///< 3 x N
  std::vector<Quat> frames;         ///< E edge frames, then the clamp frames
  std::vector<double> twist_guide;  ///< N; twist of the joint at each node to within half a turn
  double inlet_rest_length = 0;     ///< of the last edge, which grows as wire enters; that of a
                                    ///< closed rod joins the last node to the first

  Index node_count() const { return nodes.cols(); }
  Index edge_count() const { return ends.closed ? nodes.cols() : nodes.cols() - 1; }
  Index first_clamp_frame() const { return edge_count(); }
  Index last_clamp_frame() const { return edge_count() + (ends.first_clamped ? 1 : 0); }
};

/// The two frames that meet at a node; indices into RodState::frames, in the sense of growing arc.
struct Joint {
  Index node, before, after;
};

/// Calls f(Joint) for every joint of the rod, in order of nodes.
template <class F>
void for_each_joint(const RodState& state, F&& f) {
  const Index n = state.node_count();
  if (state.ends.closed) {
    f(Joint{0, n - 1, 0});
  } else if (state.ends.first_clamped) {
    f(Joint{0, state.first_clamp_frame(), 0});
  }
  for (Index i = 1; i + 1 < n; ++i) f(Joint{i, i - 1, i});
  if (state.ends.closed) {
    f(Joint{n - 1, n - 2, n - 1});
  } else if (state.ends.last_clamped) {
    f(Joint{n - 1, n - 2, state.last_clamp_frame()});
  }
}

inline Index next_node(const RodState& state, Index edge) {
  return edge + 1 < state.node_count() ? edge + 1 : 0;
}

/// Rest length of an edge.
inline double rest_length(const RodState& state, const RodParams& params, Index edge) {
  return edge == state.edge_count() - 1 ? state.inlet_rest_length : params.edge_length;
}

/// Half the rest lengths of the edges that meet at a node: the length its joint, mass and wall
/// contact stand for (half an edge at an end, so that a clamp is second order accurate).
inline double node_length(const RodState& state, const RodParams& params, Index node) {
  double length = 0;
  if (node > 0 || state.ends.closed) {
    const Index before = node > 0 ? node - 1 : state.node_count() - 1;
    length += rest_length(state, params, before) / 2;
  }
  if (node < state.edge_count()) length += rest_length(state, params, node) / 2;
  return length;
}

/// d(node_length)/d(inlet_rest_length).
inline double node_length_by_inlet(const RodState& state, Index node) {
  const Index last = state.edge_count() - 1;
  return node == last || node == next_node(state, last) ? 0.5 : 0.0;
}

/// Adds a derivative by the edge vectors (3 x E) to one by the nodes (3 x N).
void add_by_edges(const RodState& state, const Points& by_edge, Points& by_node);

/// Rest length of the whole wire.
double total_rest_length(const RodState& state, const RodParams& params);

/// A rod through the given nodes with frames transported along it from the first edge (no twist);
/// clamp frames continue the end edges. The inlet rest length is params.edge_length.
/// Throws NumericalFailure when two successive nodes coincide or an edge turns back on itself.
RodState make_rod(const Points& nodes, const RodParams& params, RodEnds ends = {});

/// Turns the frames of all edges about their tangents so that no joint has twist, keeping the last
/// frame (the nozzle's): the frames of a wire that is free to turn. Open rods only.
void remove_twist(RodState& state);

/// Turns every edge frame by the smallest rotation that takes it onto the tangent of its edge, for
/// nodes that have moved without their frames. Throws NumericalFailure where an edge has no length.
void carry_frames(RodState& state);

/// Throws NumericalFailure, naming the index, unless all numbers are finite and the frames follow
/// the edges to 1e-8.
void check_state(const RodState& state);

}  // namespace wirepack
