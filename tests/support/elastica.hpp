#pragma once

#include <array>
#include <cmath>

#include "elastic_rest.hpp"

namespace wirepack::testing {

/// Post-buckled inextensible elastica with pinned ends, in units of L, YI and the Euler load pi^2:
/// P / P_cr = (2 K / pi)^2, k = sin(alpha / 2), chord = 2 E / K - 1, h = k / K,
/// U = 8 K (E - (1 - k^2) K); elliptic integrals, checked by integrating the ODE.
struct ElasticaShape {
  double shortening;   ///< 1 - chord / L
  double load;         ///< P / P_cr
  double height;       ///< h / L
  double end_degrees;  ///< alpha
  double energy;       ///< U L / YI
};

inline constexpr std::array<ElasticaShape, 9> exact_elastica{{
    {0.01, 1.00502829, 0.06346272, 11.47112, 0.098944},
    {0.05, 1.02572426, 0.14011061, 25.75861, 0.499767},
    {0.10, 1.05298688, 0.19492431, 36.62428, 1.012602},
    {0.20, 1.11273872, 0.26631859, 52.37164, 2.080735},
    {0.30, 1.18069881, 0.31431261, 64.88829, 3.211756},
    {0.40, 1.25875903, 0.34871252, 75.83877, 4.414657},
    {0.50, 1.34944904, 0.37330643, 85.87226, 5.700592},
    {0.80, 1.73968365, 0.40313160, 113.27790, 10.219426},
    {1.00, 2.18337905, 0.39159375, 130.70991, 14.054951},
}};

/// The same by the elliptic integrals themselves.
inline ElasticaShape elastica_of_end_angle(double alpha) {
  const double k = std::sin(alpha / 2);
  const double K = std::comp_ellint_1(k), E = std::comp_ellint_2(k);
  return {2 - 2 * E / K, std::pow(2 * K / pi, 2), k / K, alpha * 180 / pi,
          8 * K * (E - (1 - k * k) * K)};
}

inline ElasticaShape elastica_of_shortening(double shortening) {
  double low = 0, high = pi;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (elastica_of_end_angle(middle).shortening < shortening ? low : high) = middle;
  }
  return elastica_of_end_angle(low);
}

/// A rod of length 1 whose ends are held at distance 1 - shortening, at rest in the plane x, z.
/// It starts from tangents at angles alpha cos(n pi s) or alpha sin(2 pi s), not from the solution.
inline ElasticaShape compressed_rod(Index edges, double shortening, bool clamped) {
  double low = 0, high = 2.4048;  // mean of cos(alpha cos s) is J0(alpha)
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (std::cyl_bessel_j(0.0, middle) > 1 - shortening ? low : high) = middle;
  }
  const RodParams params = unit_rod(edges);
  Points nodes = Points::Zero(3, edges + 1);
  for (Index j = 0; j < edges; ++j) {
    const double s = (static_cast<double>(j) + 0.5) / static_cast<double>(edges);
    const double angle = clamped ? low * std::sin(2 * pi * s) : low * std::cos(pi * s);
    nodes.col(j + 1) =
        nodes.col(j) + params.edge_length * Vec3(std::sin(angle), 0, std::cos(angle));
  }
  nodes.col(edges) = Vec3(0, 0, 1 - shortening);
  RodState state = make_rod(nodes, params, {.first_clamped = clamped, .last_clamped = clamped});
  if (clamped) {
    for (const Index frame : {state.first_clamp_frame(), state.last_clamp_frame()}) {
      Quat& q = state.frames[static_cast<std::size_t>(frame)];
      q = transport(third_axis(q), Vec3::UnitZ()) * q;
    }
  }
  HeldUnknowns held = HeldUnknowns::none(state);
  hold_coordinate(held, 1);
  held.angle.assign(held.angle.size(), true);  // in the plane nothing twists
  held.hold_node(0);
  held.hold_node(edges);
  // Ends that meet let a pinned rod turn about them, and a clamped one, a closed curve, slide along
  // itself; by symmetry its middle stays, and no force acts there.
  if (shortening == 1) held.coordinate[static_cast<std::size_t>(3 * (edges / 2) + 2)] = true;
  rest(state, held, params);
  const Points force = reactions(state, params).force;
  const Vec3 first_tangent = tangent(state, 0);
  return {shortening, -force(2, edges) / (pi * pi), state.nodes.row(0).cwiseAbs().maxCoeff(),
          std::atan2(std::abs(first_tangent.x()), first_tangent.z()) * 180 / pi,
          joint_energies(params, state).bend};
}

}  // namespace wirepack::testing
