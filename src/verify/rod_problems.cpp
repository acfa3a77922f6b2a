#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "wirepack/core/error.hpp"
#include "wirepack/core/rotation.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/load_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"

#include "problems.hpp"

namespace wirepack {

namespace {

// Nodes in the plane y, z, frames without twist.
HeldUnknowns held_in_plane(const RodState& state) {
  HeldUnknowns held = HeldUnknowns::none(state);
  for (std::size_t k = 0; k < held.coordinate.size(); k += 3) held.coordinate[k] = true;
  held.angle.assign(held.angle.size(), true);
  return held;
}

// One end turned by ten turns against the other: M = C Theta / L, U = C Theta^2 / (2 L).
KnownProblem torsion() {
  const Index edges = 30;
  const double length = 3, turns = 10;
  const RodParams params = unit_rod(edges, length, 4e4);
  RodState state = make_rod(straight_rod_nodes(edges, length), params,
                            {.first_clamped = true, .last_clamped = true});
  HeldUnknowns held = HeldUnknowns::none(state);
  held.coordinate.assign(held.coordinate.size(), true);  // else it buckles into a helix
  held.angle[static_cast<std::size_t>(state.first_clamp_frame())] = true;
  held.angle[static_cast<std::size_t>(state.last_clamp_frame())] = true;
  JointEnergy joints(params);
  // a third of a turn at a time, all of it at the end, for the solver to spread
  const auto last = static_cast<std::size_t>(state.last_clamp_frame());
  EquilibriumReport report;
  for (int step = 0; step < 30; ++step) {
    state.frames[last] = rotation_about(Vec3::UnitZ(), 2 * pi / 3) * state.frames[last];
    state.twist_guide.back() += 2 * pi / 3;
    report = find_equilibrium(state, held, EnergyTerms{joints}, {1e-6, 1e-6}, 1);
  }
  const double twist = 2 * pi * turns;
  return {"torsion by ten turns: energy", stiffness(params).twist * twist * twist / (2 * length),
          report.energy, 1e-9, "exact for any number of edges"};
}

// A chain of N equal edges with pinned ends buckles at 4 N^2 sin^2(pi / 2 N) YI / L^2. Its mode has
// the edge angles A cos(pi (j + 1/2) / N), and the load is bending energy over shortening.
KnownProblem discrete_euler_load() {
  const Index edges = 20;
  const RodParams params = unit_rod(edges, 1, 4e4);
  Points nodes = Points::Zero(3, edges + 1);
  const double step = pi / static_cast<double>(edges);
  double shortening = 0;
  for (Index j = 0; j < edges; ++j) {
    const double angle = 1e-3 * std::cos(step * (static_cast<double>(j) + 0.5));
    nodes.col(j + 1) =
        nodes.col(j) + params.edge_length * Vec3(0, std::sin(angle), std::cos(angle));
    shortening += params.edge_length * 2 * std::pow(std::sin(angle / 2), 2);
  }
  const double bend = joint_energies(params, make_rod(nodes, params)).bend;
  const double s = std::sin(step / 2);
  return {"Euler load of 20 edges, pinned [YI / L^2]", 4 * 400 * s * s, bend / shortening, 1e-6,
          "angles of 1e-3, squared"};
}

// A tip moment 2 pi YI / L closes the rod to a circle; in steps, so that the angle is followed.
KnownProblem closing_moment() {
  const Index edges = 100;
  const RodParams params = unit_rod(edges, 1, 4e4);
  RodState state = make_rod(straight_rod_nodes(edges, 1), params, {.first_clamped = true});
  HeldUnknowns held = held_in_plane(state);
  held.hold_node(0);
  EdgeMoment moment{edges - 1, Vec3::UnitX(), 0, state.frames[static_cast<std::size_t>(edges - 1)]};
  for (int step = 1; step <= 8; ++step) {
    moment.moment = 2 * pi * step / 8;
    Loads loads;
    loads.moments.push_back(moment);
    StretchEnergy stretch(params);
    JointEnergy joints(params);
    LoadEnergy load(params, loads);
    EnergyTerms total{stretch, joints, load};
    find_equilibrium(state, held, total, {1e-3, 1e-4}, 1);
    moment.angle_guide = moment.angle(state);
  }
  // the last edge is half an edge short of the end; turns are exact to (turn per edge)^2 / 3
  const double whole = moment.angle(state) * 100 / 99.5;
  return {"turn of a rod by the moment 2 pi YI / L [2 pi]", 1, whole / (2 * pi), 2e-3,
          "order 2: turn of an edge squared, over 3"};
}

}  // namespace

std::vector<KnownProblem> straight_rod_problems() {
  return {torsion(), discrete_euler_load(), closing_moment()};
}

std::vector<KnownProblem> elastica_problems() {
  // shortening, P / P_cr, h / L, U L / YI: elliptic integrals
  constexpr std::array<std::array<double, 4>, 3> exact{{{0.05, 1.02572426, 0.14011061, 0.499767},
                                                        {0.20, 1.11273872, 0.26631859, 2.080735},
                                                        {0.50, 1.34944904, 0.37330643, 5.700592}}};
  constexpr std::string_view why = "order 2: 0.05 % at 100 edges";
  const Index edges = 100;
  const RodParams params = unit_rod(edges, 1, 1e6);
  std::vector<KnownProblem> found;
  for (const auto& [shortening, load, height, energy] : exact) {
    // an arc of about the right chord; the ends are then moved to their places
    Points nodes = Points::Zero(3, edges + 1);
    const double chord = 1 - shortening;
    const double rise = std::sqrt(shortening) * 0.6;
    for (Index i = 0; i <= edges; ++i) {
      const double s = static_cast<double>(i) / static_cast<double>(edges);
      nodes.col(i) = Vec3(0, rise * std::sin(pi * s), chord * s);
    }
    RodState state = make_rod(nodes, params);
    HeldUnknowns held = held_in_plane(state);
    held.hold_node(0);
    held.hold_node(edges);
    StretchEnergy stretch(params);
    JointEnergy joints(params);
    EnergyTerms total{stretch, joints};
    find_equilibrium(state, held, total, {2e-3, 1e-4}, 1);
    Gradient gradient;
    set_zero(gradient, state);
    total.add_gradient(state, gradient);
    const FrameChart chart(state, HeldUnknowns::none(state));
    Eigen::VectorXd by_x;
    chart.pull_back(state, gradient.node, gradient.frame, by_x);
    const double force = -by_x[chart.unknown(edges, 2)];
    const std::string where = ", " + std::to_string(std::lround(100 * shortening)) + " % shorter";
    found.push_back({"elastica" + where + ": force / Euler load", load, force / (pi * pi), 2e-3,
                     "order 2, and forces left"});
    found.push_back(
        {"elastica" + where + ": height / L", height, state.nodes.row(1).maxCoeff(), 1e-3, why});
    found.push_back({"elastica" + where + ": energy [YI / L]", energy,
                     joint_energies(params, state).bend, 1e-3, why});
  }
  return found;
}

namespace {

// Second derivative of the energy of a ring whose material is naturally twisted by -turns: the same
// as a ring cut, turned and joined again. Central differences of the exact gradient.
Eigen::MatrixXd ring_hessian(Index edges, double turns) {
  RodParams params = unit_rod(edges, 1, 4e4);
  const double radius = params.edge_length / (2 * std::sin(pi / static_cast<double>(edges)));
  const RodState ring = make_rod(polygon_nodes(edges, radius), params, {.closed = true});
  params.rest_darboux = Vec3(0, 0, -2 * pi * turns);
  HeldUnknowns held = HeldUnknowns::none(ring);
  held.hold_node(0);  // with the three below: the rigid motions
  held.coordinate[static_cast<std::size_t>(3 * (edges / 2) + 1)] = true;
  held.coordinate[static_cast<std::size_t>(3 * (edges / 2) + 2)] = true;
  held.coordinate[static_cast<std::size_t>(3 * (edges / 4) + 2)] = true;
  held.angle[0] = true;  // and the spin of the whole wire
  StretchEnergy stretch(params);
  JointEnergy joints(params);
  EnergyTerms total{stretch, joints};
  const FrameChart chart(ring, held);
  RodState moved = chart.reference();
  Gradient gradient;
  const auto gradient_at = [&](Index k, double step) {
    Eigen::VectorXd x = chart.unknowns(), by_x;
    x[k] += step;
    chart.set_state(x, moved);
    set_zero(gradient, moved);
    total.add_gradient(moved, gradient);
    chart.pull_back(moved, gradient.node, gradient.frame, by_x);
    return by_x;
  };
  Eigen::MatrixXd hessian(chart.size(), chart.size());
  const double h = 1e-4 * params.edge_length;
  for (Index k = 0; k < chart.size(); ++k) {
    hessian.col(k) = (gradient_at(k, h) - gradient_at(k, -h)) / (2 * h);
  }
  return (hessian + hessian.transpose()) / 2;
}

}  // namespace

// Michell 1889: a twisted ring leaves its plane at sqrt(3) YI / GJ turns. The Hessian is linear in
// the turns, so the first singular one is an eigenvalue.
std::vector<KnownProblem> twisted_ring_problems() {
  const Index edges = 60;
  const Eigen::MatrixXd untwisted = ring_hessian(edges, 0);
  const Eigen::MatrixXd per_turn = untwisted - ring_hessian(edges, 1);
  const Eigen::LLT<Eigen::MatrixXd> factor(untwisted);
  if (factor.info() != Eigen::Success) throw NumericalFailure("the untwisted ring is not stable");
  const Eigen::MatrixXd half = factor.matrixL().solve(per_turn);
  const Eigen::MatrixXd reduced = factor.matrixL().solve(half.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((reduced + reduced.transpose()) / 2,
                                                              Eigen::EigenvaluesOnly);
  return {{"turns at which a twisted ring buckles", std::sqrt(3.0) * 4 / 3,
           1 / solver.eigenvalues().maxCoeff(), 1e-2, "order 2: turn of an edge squared"}};
}

}  // namespace wirepack
