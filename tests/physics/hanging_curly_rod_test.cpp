#include <cmath>
#include <gtest/gtest.h>
#include <utility>

#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/load_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/solve/stability.hpp"

#include "../support/sample_rods.hpp"

namespace wirepack {
namespace {

constexpr Index edges = 80;
constexpr double length = 80;

// A rod whose rest shape is an arc of this angle hangs from a clamp that points down, under its
// weight in parts of YI / L^3. It starts straight, so it stays in the plane of the arc as long as
// nothing tells either side of that plane from the other.
struct HangingRod {
  HangingRod(double angle, double weight) {
    params.edge_length = length / edges;
    params.rest_darboux = Vec3(angle / length, 0, 0);
    rod = make_rod(testing::straight_nodes(edges, length), params, {.last_clamped = true});
    held = HeldUnknowns::none(rod);
    held.hold_node(edges);
    held.angle.back() = true;
    const double bend = stiffness(params).bend;
    loads.weight = Vec3(0, 0, -weight * bend / std::pow(length, 3));
    options = equilibrium_options(bend, 1, 1e-5 * bend / (length * length));
    options.exactness = 0.7;
  }
  EquilibriumReport rest(bool at_a_minimum) {
    StretchEnergy stretch(params);
    JointEnergy joints(params);
    LoadEnergy load(params, loads);
    const EnergyTerms energy{stretch, joints, load};
    if (at_a_minimum) return solve_stable_equilibrium(rod, held, energy, options, 0.5);
    EquilibriumReport report = solve_equilibrium(rod, held, energy, options);
    SolverWork work;
    report.stable = stability_of(rod, held, energy, options, work).stable;
    return report;
  }
  double out_of_plane() const { return rod.nodes.row(0).cwiseAbs().maxCoeff(); }

  RodParams params;
  RodState rod;
  HeldUnknowns held;
  Loads loads;
  EquilibriumOptions options;
};

// An arc of 3 rad stays planar under any weight. One of some 5.83 rad loses its planar shape to a
// helical one at a weight of 20 YI / L^3, in a pitchfork: the way out of the plane grows as a
// square root.
TEST(HangingCurlyRod, stays_planar_up_to_its_stability_limit_and_leaves_the_plane_just_beyond) {
  for (const auto& [angle, weight] :
       {std::pair(3.0, 5.0), std::pair(3.0, 20.0), std::pair(3.0, 500.0), std::pair(5.82, 20.0)}) {
    HangingRod rod(angle, weight);
    const EquilibriumReport report = rod.rest(true);
    EXPECT_EQ(report.end, EquilibriumEnd::converged);
    EXPECT_TRUE(report.stable);
    EXPECT_LT(rod.out_of_plane(), 1e-6 * length);
  }
  double before = 0;
  for (const double angle : {5.84, 5.86}) {
    HangingRod planar(angle, 20), free(angle, 20);
    const EquilibriumReport saddle = planar.rest(false), minimum = free.rest(true);
    EXPECT_EQ(saddle.end, EquilibriumEnd::converged);
    EXPECT_FALSE(saddle.stable) << angle;
    EXPECT_LT(planar.out_of_plane(), 1e-6 * length);
    EXPECT_EQ(minimum.end, EquilibriumEnd::converged);
    EXPECT_TRUE(minimum.stable) << angle;
    EXPECT_LT(double(minimum.energy), double(saddle.energy));
    EXPECT_GT(free.out_of_plane(), before + 0.05 * length);
    before = free.out_of_plane();
  }
}

}  // namespace
}  // namespace wirepack
