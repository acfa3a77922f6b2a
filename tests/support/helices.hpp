#pragma once

#include <cmath>

#include "wirepack/rod/rod_strain.hpp"

#include "elastic_rest.hpp"
#include "sample_rods.hpp"

namespace wirepack::testing {

/// Helix about the z axis of given curvature and torsion, by arc length from (radius, 0, 0).
struct Helix {
  double curvature, torsion;

  double rate() const { return std::hypot(curvature, torsion); }  // turn per arc length
  double radius() const { return curvature / (rate() * rate()); }
  double pitch() const { return 2 * pi * torsion / (rate() * rate()); }
  Vec3 point(double s) const {
    const double a = rate() * s;
    return {radius() * std::cos(a), radius() * std::sin(a), torsion / rate() * s};
  }
  Vec3 tangent(double s) const {
    const double a = rate() * s, c = curvature / rate();
    return {-c * std::sin(a), c * std::cos(a), torsion / rate()};
  }
  /// d3 the tangent, d1 the binormal, so that the Darboux vector is (curvature, 0, torsion).
  Quat frame(double s) const {
    const double a = rate() * s;
    const Vec3 t = tangent(s), normal(-std::cos(a), -std::sin(a), 0);
    Mat3 axes;
    axes << t.cross(normal), -normal, t;
    return Quat(axes);
  }
};

/// A rod along the helix with the frames of the helix, clamps included.
inline RodState rod_on_helix(const Helix& helix, const RodParams& params, Index edges,
                             RodEnds ends) {
  Points nodes(3, edges + 1);
  for (Index i = 0; i <= edges; ++i) {
    nodes.col(i) = helix.point(params.edge_length * static_cast<double>(i));
  }
  RodState state = make_rod(nodes, params, ends);
  const auto put = [&](Index index, double s) {
    Quat& frame = state.frames[static_cast<std::size_t>(index)];
    const Quat exact = helix.frame(s);
    frame = transport(third_axis(exact), third_axis(frame)) * exact;
  };
  const double length = params.edge_length * static_cast<double>(edges);
  for (Index j = 0; j < edges; ++j) put(j, params.edge_length * (static_cast<double>(j) + 0.5));
  if (ends.first_clamped)
    state.frames[static_cast<std::size_t>(state.first_clamp_frame())] = helix.frame(0);
  if (ends.last_clamped)
    state.frames[static_cast<std::size_t>(state.last_clamp_frame())] = helix.frame(length);
  state.twist_guide = joint_twists(state);
  return state;
}

/// Radius, signed pitch (right-handed > 0) of the polygon around its middle: of points in a screw
/// motion the second differences point to the axis.
struct MeasuredHelix {
  double radius, pitch;
};

inline MeasuredHelix measured_helix(const RodState& state) {
  const Index i = state.node_count() / 2;
  const auto second_difference = [&](Index k) -> Vec3 {
    return state.nodes.col(k + 1) - 2 * state.nodes.col(k) + state.nodes.col(k - 1);
  };
  const Vec3 a = second_difference(i), b = second_difference(i + 1);
  const Vec3 axis = a.cross(b).normalized();
  const double turn = std::atan2(a.cross(b).norm(), a.dot(b));
  const double rise = (state.nodes.col(i + 1) - state.nodes.col(i)).dot(axis);
  return {a.norm() / (2 * (1 - std::cos(turn))), rise * 2 * pi / turn};
}

/// A rod of length 12 with rest curvature and torsion, clamped at one end only and let go straight;
/// more than two turns.
struct ReleasedHelix {
  MeasuredHelix shape;
  double energy;
};

inline ReleasedHelix released_helix(Index edges, const Helix& rest_shape) {
  RodParams params = unit_rod(edges, 12);
  params.rest_darboux = Vec3(rest_shape.curvature, 0, rest_shape.torsion);
  RodState state = make_rod(straight_nodes(edges, 12), params, {.first_clamped = true});
  HeldUnknowns held = HeldUnknowns::none(state);
  held.hold_node(0);
  hold_angle(held, state.first_clamp_frame());
  rest(state, held, params);
  return {measured_helix(state), elastic_energy(state, params)};
}

/// Wrench on the end of a rod with rest curvature 1 and torsion 0, YI = 1, GJ = 2/3, clamped at
/// both ends onto a helix.
struct Wrench {
  double force, moment;  // along and about the axis
};

inline Wrench held_helix(Index edges, const Helix& helix) {
  constexpr double length = 10;  // one and a half turns
  RodParams params = unit_rod(edges, length, inextensible, 0.5);
  params.rest_darboux = Vec3(1, 0, 0);
  RodState state =
      rod_on_helix(helix, params, edges, {.first_clamped = true, .last_clamped = true});
  HeldUnknowns held = HeldUnknowns::none(state);
  held.hold_node(0);
  held.hold_node(edges);
  hold_angle(held, state.first_clamp_frame());
  hold_angle(held, state.last_clamp_frame());
  rest(state, held, params);
  const Reactions reaction = reactions(state, params);
  const Vec3 force = reaction.force.col(edges);
  const Vec3 moment = reaction.moment.col(state.last_clamp_frame());
  return {force.z(), moment.z() + state.nodes.col(edges).cross(force).z()};
}

/// F and M of a helix held at curvature k and torsion t (Kirchhoff; Love 1927, section 271).
inline Wrench exact_wrench(const Helix& held, double rest_curvature, double rest_torsion,
                           double bend, double twist) {
  const double k = held.curvature, t = held.torsion, rate = held.rate();
  const double bend_moment = bend * (k - rest_curvature);
  const double twist_moment = twist * (t - rest_torsion);
  return {rate * (twist_moment - bend_moment * t / k), (twist_moment * t + bend_moment * k) / rate};
}

}  // namespace wirepack::testing
