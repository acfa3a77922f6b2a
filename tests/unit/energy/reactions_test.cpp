#include "wirepack/energy/reactions.hpp"

#include <gtest/gtest.h>

#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/load_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/solve/stability.hpp"

#include "../../support/clamped_rod.hpp"

namespace wirepack {
namespace {

TEST(Reactions, of_a_clamp_is_the_opposite_of_the_load_and_of_free_nodes_nothing) {
  constexpr Index edges = 40;
  RodParams wire;
  auto [rod, held] = testing::clamped_rod(edges, wire, {.first_clamped = true});
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
