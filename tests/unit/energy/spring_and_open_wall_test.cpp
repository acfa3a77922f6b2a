#include <gtest/gtest.h>

#include "wirepack/core/error.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/open_wall_energy.hpp"
#include "wirepack/energy/spring_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/solve/stability.hpp"

#include "../../support/clamped_rod.hpp"
#include "../../support/exact_gradient.hpp"

namespace wirepack {
namespace {

using testing::expect_exact_gradient;

TEST(SpringEnergy, gradient_matches_differences) {
  const RodState state = testing::random_rod(12, RodParams{}, {}, 3);
  SpringEnergy springs({{2, Vec3(1, 2, 3), 0.7}, {9, Vec3(-1, 0, 4), 2}});
  expect_exact_gradient(state, springs);
}

TEST(OpenWallEnergy, gradient_and_inlet_derivative_match_differences) {
  RodState state = testing::random_rod(12, RodParams{}, {}, 5);
  state.inlet_rest_length = 0.8;
  const Vec3 last = state.nodes.col(state.node_count() - 1);
  OpenWallEnergy walls(RodParams{},
                       {PlaneWall{last - Vec3(0, 0, 0.3), Vec3::UnitZ()},
                        CylinderWall{last - Vec3(0.8, 0.6, 0), Vec3::UnitZ(), 1.3}},
                       3);
  expect_exact_gradient(state, walls);
  testing::expect_exact_inlet_derivative(state, walls);
}

// An edge of length l that lies 0.1 deep in a wall, along it.
TEST(OpenWallEnergy, an_edge_that_lies_in_a_wall_has_the_energy_and_force_of_its_overlap) {
  const RodParams wire;
  const double overlap = 0.1, stiffness = 3, length = 1;
  for (const OpenWall& wall : {OpenWall{PlaneWall{Vec3::Zero(), Vec3::UnitX()}},
                               OpenWall{CylinderWall{Vec3(7, 0, 0), Vec3::UnitZ(), 7}}}) {
    Points nodes = Points::Zero(3, 2);
    nodes.row(0).setConstant(wire.radius - overlap);
    nodes(2, 1) = length;
    const RodState rod = make_rod(nodes, wire);
    OpenWallEnergy energy(wire, {wall}, stiffness);
    Gradient gradient;
    set_zero(gradient, rod);
    EXPECT_NEAR(double(energy.add_gradient(rod, gradient)),
                stiffness * length / 2 * overlap * overlap, 1e-14);
    EXPECT_NEAR(gradient.node.rowwise().sum()[0], -stiffness * length * overlap, 1e-13);
  }
}

TEST(OpenWallEnergy, walls_that_are_none_are_refused) {
  const auto made = [](OpenWall wall) { OpenWallEnergy(RodParams{}, {wall}, 1); };
  EXPECT_THROW(made(PlaneWall{Vec3::Zero(), Vec3(0, 0, 2)}), InvalidInput);
  EXPECT_THROW(made(CylinderWall{Vec3::Zero(), Vec3::Zero(), 3}), InvalidInput);
  EXPECT_THROW(made(CylinderWall{Vec3::Zero(), Vec3::UnitX(), 0.5}), InvalidInput);
}

// A straight wire along z, clamped at node 0, whose tip a spring of k pulls across to a point at d:
// with the stiffness 3 YI / L^3 of a cantilever the tip goes to d k / (k + 3 YI / L^3).
TEST(SpringEnergy, a_cantilever_shares_a_deflection_with_a_spring_as_their_stiffnesses_say) {
  constexpr Index edges = 60;
  RodParams wire;
  wire.stretch_multiplier = 100;
  const double length = edges, cantilever = 3 * stiffness(wire).bend / std::pow(length, 3);
  const testing::HeldRod straight = testing::clamped_rod(edges, wire, {.first_clamped = true});
  const StretchEnergy stretch(wire);
  const JointEnergy joints(wire);
  const double unit = stiffness(wire).bend / (length * length);
  const auto deflection = [&](const EnergyTerms& terms) {
    RodState rod = straight.rod;
    const EquilibriumReport found =
        solve_stable_equilibrium(rod, straight.held, terms,
                                 equilibrium_options(stiffness(wire).bend, length, 1e-6 * unit), 1);
    EXPECT_EQ(found.end, EquilibriumEnd::converged);
    return rod.nodes(0, edges);
  };
  const double d = 0.6;  // of 60, so that the deflection is small
  for (const double k : {cantilever, 4 * cantilever}) {
    const SpringEnergy spring({{edges, Vec3(d, 0, length), k}});
    EXPECT_NEAR(deflection({stretch, joints, spring}) / d, k / (k + cantilever), 2e-3);
  }
  // a plane that is pushed against the tip takes it along, whatever pulls it back
  const PlaneWall plane{Vec3(d - wire.radius, 0, 0), Vec3::UnitX()};
  const OpenWallEnergy wall(wire, {plane}, 5);
  const SpringEnergy aside({{edges, Vec3(-1, 0, length), cantilever}});
  EXPECT_GT(deflection({stretch, joints, wall, aside}), 0.99 * d);
}

}  // namespace
}  // namespace wirepack
