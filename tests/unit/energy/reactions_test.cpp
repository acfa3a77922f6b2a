#include "wirepack/energy/reactions.hpp"

#include <gtest/gtest.h>

#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/load_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/solve/stability.hpp"

#include "../../support/sample_rods.hpp"

namespace wirepack {
namespace {

TEST(Reactions, of_a_clamp_is_the_opposite_of_the_load_and_of_free_nodes_nothing) {
  constexpr Index edges = 40;
  RodParams wire;
  Points nodes = Points::Zero(3, edges + 1);
  for (Index i = 0; i <= edges; ++i) nodes(2, i) = static_cast<double>(i);
  RodState rod = make_rod(nodes, wire, {.first_clamped = true});
  HeldUnknowns held = HeldUnknowns::none(rod);
  held.hold_node(0);
  held.angle[static_cast<std::size_t>(rod.first_clamp_frame())] = true;
  const double unit = stiffness(wire).bend / (edges * edges);
  const Vec3 load = unit * Vec3(1, 0.3, -0.2);
  const StretchEnergy stretch(wire);
  const JointEnergy joints(wire);
  const LoadEnergy loads(wire, Loads{{{edges, load}}, {}, Vec3::Zero()});
  const EnergyTerms terms{stretch, joints, loads};
  const EquilibriumReport found = solve_stable_equilibrium(
      rod, held, terms, equilibrium_options(stiffness(wire).bend, edges, 1e-6 * unit), 1);
  ASSERT_EQ(found.end, EquilibriumEnd::converged);
  Gradient gradient;
  set_zero(gradient, rod);
  terms.add_gradient(rod, gradient);
  const Points force = reactions(rod, gradient);
  EXPECT_LT((force.col(0) + load).norm(), 1e-4 * unit);
  EXPECT_LT(force.rightCols(edges).colwise().norm().maxCoeff(), 1e-4 * unit);
}

}  // namespace
}  // namespace wirepack
