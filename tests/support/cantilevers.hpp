#pragma once

#include <array>
#include <cmath>

#include "elastic_rest.hpp"
#include "sample_rods.hpp"

namespace wirepack::testing {

/// Clamped along z at the origin, bent towards x. Length and YI are 1.
struct Cantilever {
  double load;             ///< P L^2 / YI at the tip, or w L^3 / YI
  double tip_degrees;      ///< slope of the tip
  double drop;             ///< deflection of the tip
  double height_by_width;  ///< deflection over projected length
  double pull_in;          ///< 1 - projected length
  double root_curvature;   ///< at the clamp
};

/// Tip load: Bisshopp and Drucker 1945, elliptic integrals.
struct TipLoaded {
  double load, tip_degrees, drop, pull_in;
};
inline constexpr std::array<TipLoaded, 6> exact_tip_loaded{{
    {0.5, 14.010746, 0.16214358, 0.01591896},
    {1, 26.433520, 0.30172077, 0.05643324},
    {2, 44.790966, 0.49345748, 0.16064172},
    {3, 56.494610, 0.60325344, 0.25442018},
    {5, 69.635464, 0.71379152, 0.38762836},
    {10, 81.949325, 0.81060902, 0.55499560},
}};

/// Own weight: integrated ODE; the master curve of Romero et al. 2021.
struct Heavy {
  double weight, height_by_width, drop, root_curvature;
};
inline constexpr std::array<Heavy, 5> exact_heavy{{
    {0.1, 0.0124996, 0.0124984, 0.049997},
    {1, 0.1245618, 0.1234714, 0.496933},
    {10, 1.0668023, 0.7001997, 3.742191},
    {100, 5.8881046, 0.9375239, 13.693239},
    {1000, 21.3354405, 0.9811413, 44.297658},
}};

inline Cantilever rest_of_cantilever(Index edges, double load, const Loads& loads) {
  const RodParams params = unit_rod(edges);
  RodState state = make_rod(straight_nodes(edges, 1), params, {.first_clamped = true});
  HeldUnknowns held = HeldUnknowns::none(state);
  held.hold_node(0);
  hold_coordinate(held, 1);
  held.angle.assign(held.angle.size(), true);  // in the plane nothing twists
  rest(state, held, params, loads);
  const Vec3 tip = state.nodes.col(edges);
  const Vec3 end = tangent(state, edges - 1);
  const Vec3 clamp_moment = reactions(state, params).moment.col(state.first_clamp_frame());
  return {load,        std::atan2(end.x(), end.z()) * 180 / pi,
          tip.x(),     tip.x() / tip.z(),
          1 - tip.z(), clamp_moment.norm()};
}

inline Cantilever tip_loaded_cantilever(Index edges, double load) {
  Loads loads;
  loads.forces.push_back({edges, Vec3(load, 0, 0)});
  return rest_of_cantilever(edges, load, loads);
}

inline Cantilever heavy_cantilever(Index edges, double weight) {
  Loads loads;
  loads.weight = Vec3(weight, 0, 0);
  return rest_of_cantilever(edges, weight, loads);
}

/// 45 degree arc of radius 100 in the plane x, y, clamped along x, with a force along z at its tip
/// (Bathe and Bolourchi 1979): YI = GJ = 1e7 / 12, YA = 1e7. Returns the tip from the root.
inline Vec3 bathe_tip(Index edges, double force, double stretch_multiplier = 1) {
  constexpr double radius = 100, arc = pi / 4;
  RodParams params;
  params.radius = std::sqrt(4.0 / 12);  // YI / YA = a^2 / 4
  params.youngs_modulus = 1e7 / (pi * params.radius * params.radius);
  params.poisson_ratio = 0;  // GJ = YI
  params.stretch_multiplier = stretch_multiplier;
  params.edge_length = radius * arc / static_cast<double>(edges);
  params.rest_darboux = Vec3(1 / radius, 0, 0);
  Points nodes(3, edges + 1);
  for (Index i = 0; i <= edges; ++i) {
    const double angle = arc * static_cast<double>(i) / static_cast<double>(edges);
    nodes.col(i) = radius * Vec3(std::sin(angle), 1 - std::cos(angle), 0);
  }
  RodState state = make_rod(nodes, params, {.first_clamped = true});
  // d1 = z is the axis of the rest curvature, d3 = x
  Mat3 clamp;
  clamp << Vec3::UnitZ(), -Vec3::UnitY(), Vec3::UnitX();
  const Quat clamp_frame(clamp);
  for (Index j = 0; j < edges; ++j) {
    state.frames[static_cast<std::size_t>(j)] =
        transport(Vec3::UnitX(), tangent(state, j)) * clamp_frame;
  }
  state.frames[static_cast<std::size_t>(state.first_clamp_frame())] = clamp_frame;
  HeldUnknowns held = HeldUnknowns::none(state);
  held.hold_node(0);
  hold_angle(held, state.first_clamp_frame());
  Loads loads;
  loads.forces.push_back({edges, Vec3(0, 0, force)});
  rest(state, held, params, loads, {1e-5 * std::max(force, 10.0), 1e-4 * std::max(force, 10.0)});
  return state.nodes.col(edges);
}

struct BatheTip {
  double force;
  std::array<double, 3> tip;
};
/// Inextensible Kirchhoff rod, integrated ODE; F / YA = 6e-5 of the arc moves the tip by 0.003.
inline constexpr std::array<BatheTip, 3> exact_bathe{{
    {300, {58.77969, 22.24503, 40.18828}},
    {450, {52.23930, 18.50846, 48.49798}},
    {600, {47.15129, 15.68508, 53.46860}},
}};

}  // namespace wirepack::testing
