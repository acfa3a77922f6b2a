#include "wirepack/feed/feeder.hpp"

#include <algorithm>

#include "wirepack/core/rotation.hpp"
#include "wirepack/rod/rod_strain.hpp"

namespace wirepack {

namespace {

// The fed length is shared out to so many edges. Five and twenty save as many evaluations; along
// forty the wire moves farther than it will go.
constexpr Index sharing_edges = 10;

// The place so much closer to the tip than a node >= 1, along the edges and straight on beyond.
Vec3 closer_to_tip(const Points& nodes, Index node, double way) {
  while (node > 1 && way > (nodes.col(node - 1) - nodes.col(node)).norm()) {
    way -= (nodes.col(node - 1) - nodes.col(node)).norm();
    --node;
  }
  return nodes.col(node) + way * (nodes.col(node - 1) - nodes.col(node)).normalized();
}

}  // namespace

void insert(RodState& state, double arc_length) {
  state.inlet_rest_length += arc_length;
  if (state.ends.closed) return;
  const Index last = state.node_count() - 1;
  const Index count = std::min(sharing_edges, last);
  Points nodes = state.nodes;
  for (Index k = 1; k < count; ++k) {
    const double share = 1 - static_cast<double>(k) / static_cast<double>(count);
    nodes.col(last - k) = closer_to_tip(state.nodes, last - k, share * arc_length);
  }
  state.nodes = nodes;
  carry_frames(state);
  state.twist_guide = joint_twists(state);
}

void slide_one_edge(RodState& state, const RodParams& params) {
  const Index n = state.node_count();
  const Vec3 before = (state.nodes.col(1) - state.nodes.col(2)).normalized();
  const Vec3 last = (state.nodes.col(0) - state.nodes.col(1)).normalized();
  const Quat turn = transport(before, last);
  Points nodes(3, n + 1);
  nodes.col(0) = state.nodes.col(0) + params.edge_length * (turn * last);
  nodes.rightCols(n) = state.nodes;
  state.nodes = nodes;
  state.frames.insert(state.frames.begin(), turn * state.frames.front());
  // the twist of the last joint belongs to the node that is inside now
  state.twist_guide.insert(state.twist_guide.begin(), state.twist_guide.front());
  carry_frames(state);
  state.twist_guide = joint_twists(state);
}

bool split_is_due(const RodState& state, double longest) {
  return state.inlet_rest_length >= longest * (1 - 1e-12);
}

void split_inlet(RodState& state, const Nozzle& nozzle, const RodParams& params) {
  const Index last = state.node_count() - 1;
  const double inlet = state.inlet_rest_length - params.edge_length;
  const Vec3 a = state.nodes.col(last - 1);
  const Vec3 b = state.nodes.col(last);
  const double chord = (b - a).norm();
  // The tangent at a is the mean of its two edges, each weighted by the length of the other.
  const Vec3 before = a - state.nodes.col(last - 2);
  const Vec3 tangent_a =
      (before.normalized() * chord + (b - a).normalized() * before.norm()).normalized();
  const double u = params.edge_length / state.inlet_rest_length;
  const double h00 = (1 + 2 * u) * (1 - u) * (1 - u), h10 = u * (1 - u) * (1 - u);
  const double h01 = u * u * (3 - 2 * u), h11 = u * u * (u - 1);
  const Vec3 middle = h00 * a + h10 * chord * tangent_a + h01 * b + h11 * chord * nozzle.direction;

  Points nodes(3, last + 2);
  nodes.leftCols(last) = state.nodes.leftCols(last);
  nodes.col(last) = middle;
  nodes.col(last + 1) = b;

  const auto clamp_index = static_cast<std::size_t>(state.last_clamp_frame());
  const Quat old_edge = state.frames[clamp_index - 1];
  const double clamp_twist = state.twist_guide.back();
  const Quat first = transport(third_axis(old_edge), (middle - a).normalized()) * old_edge;
  Quat second = transport(third_axis(old_edge), (b - middle).normalized()) * old_edge;
  // Twist of the clamp joint is spread over the arc from the middle of the old edge to the clamp:
  // the middles of the new edges cut it where they lie.
  const double old_half = state.inlet_rest_length / 2;
  const double second_share = (old_half - inlet / 2) / old_half;
  second = rotation_about((b - middle).normalized(), second_share * clamp_twist) * second;

  state.nodes = nodes;
  state.frames[clamp_index - 1] = first;
  state.frames.insert(state.frames.begin() + static_cast<std::ptrdiff_t>(clamp_index), second);
  state.twist_guide.back() = second_share * clamp_twist;
  state.twist_guide.push_back(clamp_twist - second_share * clamp_twist);
  state.inlet_rest_length = inlet;
  state.twist_guide = joint_twists(state);
}

}  // namespace wirepack
