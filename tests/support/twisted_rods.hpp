#pragma once

#include <cmath>

#include "elastic_rest.hpp"
#include "sample_rods.hpp"
#include "stability.hpp"

namespace wirepack::testing {

/// A closed polygon of length 1 in the plane x, y. Its material is naturally twisted by
/// -turns / L, so that the untwisted ring carries the moment GJ 2 pi turns / L: for the isotropic
/// rod the same as a ring cut, turned and joined again, for any number of turns.
struct TwistedRing {
  RodParams params;
  RodState state;
};

inline Points ring_nodes(Index edges) {
  const auto n = static_cast<double>(edges);
  const double radius = 1 / (2 * n * std::sin(pi / n));  // every edge has its rest length
  Points nodes(3, edges);
  for (Index i = 0; i < edges; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / n;
    nodes.col(i) = radius * Vec3(std::cos(angle), std::sin(angle), 0);
  }
  return nodes;
}

inline TwistedRing twisted_ring(Index edges, double poisson_ratio, double turns,
                                double stretch = 4e4) {
  TwistedRing ring{unit_rod(edges, 1, stretch, poisson_ratio), {}};
  ring.state = make_rod(ring_nodes(edges), ring.params, {.closed = true});
  ring.params.rest_darboux = Vec3(0, 0, -2 * pi * turns);
  return ring;
}

/// Statically determinate supports: the six rigid motions and the spin of the whole rod are held,
/// no deformation is.
inline HeldUnknowns ring_supports(const RodState& state) {
  HeldUnknowns held = HeldUnknowns::none(state);
  const Index n = state.node_count();
  held.hold_node(0);
  held.coordinate[static_cast<std::size_t>(3 * (n / 2) + 1)] = true;
  held.coordinate[static_cast<std::size_t>(3 * (n / 2) + 2)] = true;
  held.coordinate[static_cast<std::size_t>(3 * (n / 4) + 2)] = true;
  hold_angle(held, 0);
  return held;
}

/// Turns at which the ring loses its stability. The Hessian is linear in the turns.
inline double critical_turns(Index edges, double poisson_ratio) {
  const auto hessian = [&](double turns) {
    // stretch lowers it by about (2 pi)^2 / 2 over YA L^2 / YI: 5e-6
    const TwistedRing ring = twisted_ring(edges, poisson_ratio, turns, 4e6);
    return elastic_hessian(ring.state, ring_supports(ring.state), ring.params);
  };
  const Eigen::MatrixXd unloaded = hessian(0);
  return critical_multiplier(unloaded, unloaded - hessian(1));
}

/// Torque [YI / L] at which a straight rod under the tension T [YI / L^2] leaves its axis, by the
/// static criterion. Clamped: end frames fixed. Hinged: end nodes held, torque along the axis in
/// space. Lateral coordinates alone; at the straight rod spins and axial motion do not couple.
inline double greenhill_torque(Index edges, double tension, bool clamped) {
  const RodParams params = unit_rod(edges);
  const double twist_stiffness = stiffness(params).twist;
  const auto matrix = [&](double torque) {
    RodState state = make_rod(straight_nodes(edges, 1 + tension / inextensible), params,
                              {.first_clamped = clamped, .last_clamped = clamped});
    twist_uniformly(state, torque / twist_stiffness);
    HeldUnknowns held = HeldUnknowns::none(state);
    hold_coordinate(held, 2);
    held.hold_node(0);
    held.hold_node(edges);
    held.angle.assign(held.angle.size(), true);
    const ForceField elastic = elastic_forces(params);
    const ForceField all = [&](const RodState& moved, Gradient& gradient) {
      elastic(moved, gradient);
      if (clamped) return;
      gradient.frame.col(0) += torque * Vec3::UnitZ();
      gradient.frame.col(edges - 1) -= torque * Vec3::UnitZ();
    };
    return jacobian(state, held, all, 1e-4 * params.edge_length);
  };
  const Eigen::MatrixXd untwisted = matrix(0);
  return critical_multiplier(untwisted, (untwisted - matrix(2)) / 2);
}

}  // namespace wirepack::testing
