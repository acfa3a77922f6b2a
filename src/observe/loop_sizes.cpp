#include "wirepack/observe/loop_sizes.hpp"

#include <cmath>

#include "wirepack/observe/order.hpp"

namespace wirepack {

namespace {

struct Bend {
  double angle, length;  // between two edges, and the length it stands for
};

std::vector<Bend> bends(const RodState& state) {
  const Points tangents = edge_tangents(state);
  std::vector<Bend> result;
  for_each_joint(state, [&](const Joint& joint) {
    if (std::max(joint.before, joint.after) >= state.edge_count()) return;  // a clamp
    const Vec3 t = tangents.col(joint.before), u = tangents.col(joint.after);
    const auto length = [&](Index edge) {
      return (state.nodes.col(next_node(state, edge)) - state.nodes.col(edge)).norm();
    };
    result.push_back({std::atan2(t.cross(u).norm(), t.dot(u)),
                      (length(joint.before) + length(joint.after)) / 2});
  });
  return result;
}

}  // namespace

std::vector<double> local_curvatures(const RodState& state) {
  std::vector<double> result;
  for (const Bend& bend : bends(state)) result.push_back(bend.angle / bend.length);
  return result;
}

std::vector<double> loop_lengths(const RodState& state) {
  std::vector<double> result;
  double turned = 0, length = 0;
  for (const Bend& bend : bends(state)) {
    turned += bend.angle;
    length += bend.length;
    while (turned >= 2 * pi) {  // the part of this bend beyond the turn opens the next loop
      const double beyond = (turned - 2 * pi) / bend.angle * bend.length;
      result.push_back(length - beyond);
      turned -= 2 * pi;
      length = beyond;
    }
  }
  return result;
}

}  // namespace wirepack
