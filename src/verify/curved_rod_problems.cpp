#include <cmath>

#include "wirepack/core/rotation.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/load_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"

#include "problems.hpp"

namespace wirepack {

namespace {

// A rod of rest curvature 1 and torsion 1/2, clamped at one end, is let go from straight.
std::vector<KnownProblem> released_helix() {
  const Index edges = 120;
  const double length = 12, curvature = 1, torsion = 0.5;
  RodParams params = unit_rod(edges, length, 4e4);
  params.rest_darboux = Vec3(curvature, 0, torsion);
  RodState state = make_rod(straight_rod_nodes(edges, length), params, {.first_clamped = true});
  HeldUnknowns held = HeldUnknowns::none(state);
  held.hold_node(0);
  held.angle[static_cast<std::size_t>(state.first_clamp_frame())] = true;
  StretchEnergy stretch(params);
  JointEnergy joints(params);
  EnergyTerms total{stretch, joints};
  const double start = joint_energies(params, state).bend;
  const EquilibriumReport report = find_equilibrium(state, held, total, {1e-6, 1e-6}, 1);
  // second differences of points on a helix point to its axis
  const auto towards_axis = [&](Index k) -> Vec3 {
    return state.nodes.col(k + 1) - 2 * state.nodes.col(k) + state.nodes.col(k - 1);
  };
  const Index i = edges / 2;
  const Vec3 a = towards_axis(i), b = towards_axis(i + 1);
  const Vec3 axis = a.cross(b).normalized();
  const double turn = std::atan2(a.cross(b).norm(), a.dot(b));
  const double rise = (state.nodes.col(i + 1) - state.nodes.col(i)).dot(axis);
  const double square = curvature * curvature + torsion * torsion;
  constexpr std::string_view why = "order 2: turn of an edge squared, over 6";
  return {{"released helix: energy left of that when straight", 0, report.energy / start, 1e-9,
           "forces left of 1e-6 YI / L^2"},
          {"released helix: radius", curvature / square, a.norm() / (2 * (1 - std::cos(turn))),
           2e-3, why},
          {"released helix: pitch, right-handed", 2 * pi * torsion / square, rise * 2 * pi / turn,
           2e-3, why}};
}

// Bathe and Bolourchi 1979: an arc of 45 degrees and radius 100 in the plane x, y, clamped along x,
// with the force 600 along z at its tip; YI = GJ = 1e7 / 12, YA = 1e7. Tip of the integrated ODE.
std::vector<KnownProblem> bathe_cantilever() {
  constexpr double radius = 100, arc = pi / 4, force = 600;
  const Index edges = 40;
  RodParams params;
  params.radius = std::sqrt(4.0 / 12);  // YI / YA = a^2 / 4
  params.youngs_modulus = 1e7 / (pi * params.radius * params.radius);
  params.poisson_ratio = 0;
  params.edge_length = radius * arc / static_cast<double>(edges);
  params.rest_darboux = Vec3(1 / radius, 0, 0);
  Points nodes(3, edges + 1);
  for (Index i = 0; i <= edges; ++i) {
    const double angle = arc * static_cast<double>(i) / static_cast<double>(edges);
    nodes.col(i) = radius * Vec3(std::sin(angle), 1 - std::cos(angle), 0);
  }
  RodState state = make_rod(nodes, params, {.first_clamped = true});
  Mat3 axes;  // the first axis, z, is that of the rest curvature
  axes << Vec3::UnitZ(), -Vec3::UnitY(), Vec3::UnitX();
  const Quat clamp(axes);
  for (Index j = 0; j < edges; ++j) {
    const Vec3 t = (nodes.col(j + 1) - nodes.col(j)).normalized();
    state.frames[static_cast<std::size_t>(j)] = transport(Vec3::UnitX(), t) * clamp;
  }
  state.frames[static_cast<std::size_t>(state.first_clamp_frame())] = clamp;
  HeldUnknowns held = HeldUnknowns::none(state);
  held.hold_node(0);
  held.angle[static_cast<std::size_t>(state.first_clamp_frame())] = true;
  Loads loads;
  loads.forces.push_back({edges, Vec3(0, 0, force)});
  StretchEnergy stretch(params);
  JointEnergy joints(params);
  LoadEnergy load(params, loads);
  EnergyTerms total{stretch, joints, load};
  find_equilibrium(state, held, total, {1e-3 * force, 1e-2 * force}, 1e7 / 12);
  constexpr std::string_view why = "order 2: 0.02 % at 40 edges";
  return {
      {"45 degree cantilever: tip along the clamp", 47.15129, state.nodes(0, edges), 1e-3, why},
      {"45 degree cantilever: tip across", 15.68508, state.nodes(1, edges), 1e-3, why},
      {"45 degree cantilever: tip along the force", 53.46860, state.nodes(2, edges), 1e-3, why}};
}

}  // namespace

std::vector<KnownProblem> curved_rod_problems() {
  std::vector<KnownProblem> found = released_helix();
  for (KnownProblem& problem : bathe_cantilever()) found.push_back(std::move(problem));
  return found;
}

}  // namespace wirepack
