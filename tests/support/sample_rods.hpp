#pragma once

#include <cmath>

#include "wirepack/core/random.hpp"
#include "wirepack/core/rotation.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack::testing {

inline Vec3 random_vector(Random& random) {
  const double x = random.symmetric(), y = random.symmetric(), z = random.symmetric();
  return {x, y, z};
}

inline Quat random_rotation(Random& random) {
  Quat q(random.symmetric(), random.symmetric(), random.symmetric(), random.symmetric());
  return q.normalized();
}

/// A smooth, bent, twisted, slightly stretched open rod with edges of about params.edge_length.
inline RodState random_rod(Index nodes, const RodParams& params, RodEnds ends, std::uint64_t seed) {
  Random random(seed);
  const Vec3 turn = 0.25 * random_vector(random);
  const Vec3 wave = 0.2 * random_vector(random);
  Points points(3, nodes);
  Vec3 tangent = random_rotation(random) * Vec3::UnitZ();
  Vec3 r = params.edge_length * random_vector(random);
  for (Index i = 0; i < nodes; ++i) {
    points.col(i) = r;
    const Vec3 spin = turn + std::sin(0.7 * static_cast<double>(i)) * wave;
    tangent = rotation_about(spin.normalized(), spin.norm()) * tangent;
    r += params.edge_length * (1 + 0.05 * random.symmetric()) * tangent;
  }
  RodState state = make_rod(points, params, ends);
  for (std::size_t j = 0; j < state.frames.size(); ++j) {
    const Vec3 t = third_axis(state.frames[j]);
    state.frames[j] = rotation_about(t, 0.3 * random.symmetric()) * state.frames[j];
  }
  return state;
}

/// Nodes of a straight rod along z from the origin; `length` in `edges` edges.
inline Points straight_nodes(Index edges, double length) {
  Points points = Points::Zero(3, edges + 1);
  for (Index i = 0; i <= edges; ++i) {
    points(2, i) = length * static_cast<double>(i) / static_cast<double>(edges);
  }
  return points;
}

}  // namespace wirepack::testing
