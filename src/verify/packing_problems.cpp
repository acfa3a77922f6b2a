#include <array>
#include <cmath>

#include "wirepack/contact/line_contact.hpp"
#include "wirepack/core/rotation.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/energy/wall_energy.hpp"
#include "wirepack/observe/packing_density.hpp"
#include "wirepack/observe/spool_model.hpp"
#include "wirepack/observe/writhe.hpp"

#include "problems.hpp"

namespace wirepack {

namespace {

// Edge j of a straight strand of unit edges around `middle`.
Line edge_of_strand(const Vec3& middle, const Vec3& direction, int j) {
  return {middle + j * direction, direction};
}

struct Repulsion {
  double energy = 0, force = 0;  // the force on the second strand along z
};
void add_pair(const LineKernel& kernel, const Line& first, const Line& second, Repulsion& sum) {
  LineGradient gradient;
  const double energy = kernel.energy(first, second, gradient);
  sum.energy += energy;
  if (energy > 0) sum.force -= gradient.midpoint2.z();
}

}  // namespace

std::vector<KnownProblem> contact_problems() {
  constexpr double stiffness = 5, overlap = 0.1;
  const LineKernel kernel = LineKernel::per_length(stiffness, 1, 1);
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY();
  // one edge of a strand against a long parallel one, on average over all offsets of their nodes
  Repulsion parallel;
  constexpr int offsets = 40;
  for (int k = 0; k < offsets; ++k) {
    const Vec3 middle(static_cast<double>(k) / offsets, 0, 2 - overlap);
    for (int j = -8; j <= 8; ++j) {
      add_pair(kernel, edge_of_strand(Vec3::Zero(), x, 0), edge_of_strand(middle, x, j), parallel);
    }
  }
  Repulsion crossing;
  for (int i = -5; i <= 5; ++i) {
    for (int j = -5; j <= 5; ++j) {
      add_pair(kernel, edge_of_strand(Vec3(0.2, 0, 0), x, i),
               edge_of_strand(Vec3(0.1, 0.4, 2 - overlap), y, j), crossing);
    }
  }
  return {{"parallel strands: force per length / (k overlap)", 1,
           parallel.force / offsets / (stiffness * overlap), 1e-3, "mean over 40 offsets"},
          {"parallel strands: energy per length / (k overlap^2 / 2)", 1,
           parallel.energy / offsets / (stiffness / 2 * overlap * overlap), 1e-3,
           "mean over 40 offsets"},
          {"crossing strands: force / (2 a k overlap)", 1,
           crossing.force / (2 * stiffness * overlap), 1e-9, "exact at a right angle"},
          {"crossing strands: energy / (a k overlap^2)", 1,
           crossing.energy / (stiffness * overlap * overlap), 1e-9, "exact at a right angle"}};
}

namespace {

constexpr double wall_stiffness = 50;

// Energy in equilibrium of a wire in a sphere, nearly inextensible.
double energy_in_ball(RodState& state, const RodParams& params, const Cavity& cavity) {
  StretchEnergy stretch(params);
  JointEnergy joints(params);
  WallEnergy wall(params, cavity, wall_stiffness);
  EnergyTerms total{stretch, joints, wall};
  const double bend = stiffness(params).bend, r = cavity.radius;
  return find_equilibrium(state, HeldUnknowns::none(state), total,
                          {1e-6 * bend / (r * r), 1e-6 * bend / r}, bend)
      .energy;
}

RodParams hoop_wire(double edge_length) {
  RodParams params;
  params.edge_length = edge_length;
  params.stretch_multiplier = 100;
  return params;
}

// A coil along the equator, free at both ends: Eshelby's force YI / (2 rho^2) at the ends presses
// it to the wall, which gives way by YI / (2 rho^3) over its stiffness.
double coil_energy(Index edges, const RodParams& params, const Cavity& cavity) {
  const double free = cavity.radius - params.radius;
  const double rho = free + stiffness(params).bend / (2 * free * free * free) / wall_stiffness;
  Points nodes(3, edges + 1);
  for (Index i = 0; i <= edges; ++i) {
    const double angle = static_cast<double>(i) * params.edge_length / rho;
    nodes.col(i) = rho * Vec3(std::cos(angle), std::sin(angle), 0);
  }
  RodState coil = make_rod(nodes, params);
  return energy_in_ball(coil, params, cavity);
}

}  // namespace

std::vector<KnownProblem> hoop_problems() {
  const Cavity cavity{10};
  const Index edges = 120;
  const double radius = 7, rho = 9;
  const RodParams loose = hoop_wire(2 * pi * radius / static_cast<double>(edges));
  RodState ring = make_rod(polygon_nodes(edges, radius), loose, {.closed = true});
  const double free_energy = energy_in_ball(ring, loose, cavity);
  const RodParams tight = hoop_wire(2 * pi * rho / static_cast<double>(edges));
  const double bend = stiffness(tight).bend;
  const double per_turn =
      coil_energy(3 * edges, tight, cavity) - coil_energy(2 * edges, tight, cavity);
  return {
      {"ring of radius 7 in a ball of 10: energy", pi * bend / radius, free_energy, 1e-3,
       "order 2: turn of an edge squared, over 6"},
      {"coil at the wall, a/R = 1/10: F R^2 / YI", 0.617284, per_turn / (2 * pi * rho) * 100 / bend,
       2e-3, "the wall gives way and the wire is compressed, by a thousandth"}};
}

std::vector<KnownProblem> spool_problems() {
  const SpoolModel spool{Cavity{40}, 1, 5 * pi / 4, 2.81};
  std::vector<KnownProblem> found;
  // phi, E R / YI, F R^2 / YI of the closed form, evaluated independently
  constexpr std::array<std::array<double, 3>, 2> exact{
      {{.10, 138.21730, .783515}, {.40, 1366.56532, 5.669295}}};
  for (const auto& [density, energy, force] : exact) {
    const std::string where = ", phi = 0." + std::to_string(std::lround(10 * density));
    found.push_back({"inverse spool" + where + ": E R / YI", energy,
                     spool.bend_energy(density) * 40 / spool.bend_stiffness, 1e-7,
                     "printed digits"});
    found.push_back({"inverse spool" + where + ": F R^2 / YI", force,
                     spool.injection_force(density) * 1600 / spool.bend_stiffness, 1e-6,
                     "printed digits"});
    const double h = 1e-5;
    const double slope = (spool.bend_energy(density + h) - spool.bend_energy(density - h)) /
                         (2 * length_at_density(h, spool.cavity, spool.wire_radius));
    found.push_back({"inverse spool" + where + ": dE/dL over F", 1,
                     slope / spool.injection_force(density), 1e-6, "differences over 1e-5"});
  }
  return found;
}

namespace {

Points trefoil(Index edges) {
  Points nodes(3, edges);
  for (Index i = 0; i < edges; ++i) {
    const double t = 2 * pi * static_cast<double>(i) / static_cast<double>(edges);
    nodes.col(i) = Vec3(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t),
                        -std::sin(3 * t));
  }
  return nodes;
}

}  // namespace

std::vector<KnownProblem> writhe_problems() {
  const double coarse = writhe(trefoil(200), true);
  const double fine = writhe(trefoil(400), true);
  RodState ribbon = make_rod(trefoil(150), RodParams{}, {.closed = true});
  for (std::size_t j = 0; j < ribbon.frames.size(); ++j) {
    const double angle = 2 * pi * 4 * static_cast<double>(j) / 150;
    ribbon.frames[j] = rotation_about(third_axis(ribbon.frames[j]), angle) * ribbon.frames[j];
  }
  const double link = linking_number(ribbon.nodes, ribbon_edge(ribbon, 1e-3));
  return {{"writhe of a trefoil, polygon of 100 edges", -3.354225, writhe(trefoil(100), true), 2e-7,
           "printed digits"},
          {"writhe of a trefoil, extrapolated", -3.354126, (4 * fine - coarse) / 3, 3e-7,
           "printed digits"},
          {"linking number of a ribbon on it: distance to a whole number", 0,
           link - std::round(link), 1e-9, "rounding"},
          {"twist + writhe - linking number (White)", 0,
           total_twist(ribbon) + writhe(ribbon) - link, 1e-9, "rounding"}};
}

}  // namespace wirepack
