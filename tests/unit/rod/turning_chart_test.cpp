#include "wirepack/rod/turning_chart.hpp"

#include <gtest/gtest.h>

#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/energy/wall_energy.hpp"

#include "../../support/sample_rods.hpp"

namespace wirepack {
namespace {

// Three turns of a coil about the centre.
Points coil() {
  Points nodes(3, 60);
  for (Index i = 0; i < nodes.cols(); ++i) {
    const double angle = 0.3 * static_cast<double>(i);
    nodes.col(i) =
        Vec3(3.3 * std::cos(angle), 3.3 * std::sin(angle), 0.1 * (static_cast<double>(i) - 30));
  }
  return nodes;
}

struct Sample {
  RodParams params;
  RodState rod = make_rod(coil(), params, {.last_clamped = true});
  FrameChart chart{rod, HeldUnknowns::none(rod)};
};

Eigen::VectorXd random_step(Index size, double amplitude, std::uint64_t seed) {
  Random random(seed);
  Eigen::VectorXd z(size);
  for (double& v : z) v = amplitude * random.symmetric();
  return z;
}

// A rotation field: the nodes' velocities and the spins about the tangents.
Eigen::VectorXd rotation_step(const FrameChart& chart, const Vec3& omega) {
  Eigen::VectorXd z = Eigen::VectorXd::Zero(chart.size());
  const RodState& rod = chart.reference();
  for (Index i = 0; i < rod.node_count(); ++i) {
    const Vec3 v = omega.cross(Vec3(rod.nodes.col(i)));
    for (int c = 0; c < 3; ++c) z[chart.unknown(i, c)] = v[c];
  }
  for (Index j = 0; j < rod.edge_count(); ++j) {
    z[chart.unknown(j, 3)] = omega.dot(chart.reference_tangent(j));
  }
  return z;
}

TEST(TurningChart, IsTheIdentityToFirstOrder) {
  Sample s;
  TurningChart turning(s.chart, 5);
  const Eigen::VectorXd z = random_step(s.chart.size(), 1, 3);
  const auto distance = [&](double h) {
    RodState bent = s.chart.reference(), straight = bent;
    turning.set_state(h * z, bent);
    s.chart.set_state(s.chart.unknowns() + h * z, straight);
    double worst = (bent.nodes - straight.nodes).cwiseAbs().maxCoeff();
    for (std::size_t j = 0; j < bent.frames.size(); ++j) {
      worst = std::max(worst, bent.frames[j].angularDistance(straight.frames[j]));
    }
    return worst;
  };
  EXPECT_GT(distance(1e-2), 1e-7);                 // the map does something
  EXPECT_LT(distance(1e-3), distance(1e-2) / 80);  // second order: a hundredth
}

TEST(TurningChart, StraightStepAlongARotationTurnsTheWireAsAWhole) {
  Sample s;
  TurningChart turning(s.chart, 1e-9);  // full weight at once behind the last node
  const Vec3 omega(0.3, -0.5, 0.4);
  RodState turned = s.chart.reference();
  turning.set_state(rotation_step(s.chart, omega), turned);
  StretchEnergy stretch(s.params);
  WallEnergy wall(s.params, Cavity{2}, 5);
  const auto energy = [](const auto& term, const RodState& state) {
    Gradient unused;
    set_zero(unused, state);
    return term.add_gradient(state, unused);
  };
  // all edges but the last keep their lengths and places; straight steps of 0.7 rad would not
  for (Index i = 0; i + 1 < turned.node_count(); ++i) {
    EXPECT_NEAR(turned.nodes.col(i).norm(), s.rod.nodes.col(i).norm(), 2e-3 * s.rod.nodes.norm());
  }
  RodState straight = s.chart.reference();
  s.chart.set_state(s.chart.unknowns() + rotation_step(s.chart, omega), straight);
  const double before = energy(stretch, s.rod);
  EXPECT_LT(std::abs(energy(stretch, turned) - before),
            0.1 * std::abs(energy(stretch, straight) - before));
  EXPECT_LT(turning.moves().norm(), 0.05 * rotation_step(s.chart, omega).norm());
}

TEST(TurningChart, DerivativesMatchDifferencesWithAndWithoutTurning) {
  for (const double taper : {0.0, 5.0}) {
    Sample s;
    TurningChart turning(s.chart, taper);
    StretchEnergy stretch(s.params);
    JointEnergy joints(s.params);
    WallEnergy wall(s.params, Cavity{4}, 5);
    EnergyTerms total{stretch, joints, wall};
    RodState state = s.chart.reference();
    Gradient gradient;
    // the energy plus a function of the moves: sum |move|^2
    const auto energy = [&](const Eigen::VectorXd& z) {
      turning.set_state(z, state);
      set_zero(gradient, state);
      return double(total.add_gradient(state, gradient)) + turning.moves().squaredNorm();
    };
    const Eigen::VectorXd z0 = random_step(s.chart.size(), 0.15, 8);
    energy(z0);
    Eigen::VectorXd by_x, by_z;
    turning.pull_back(state, gradient.node, gradient.frame, 2 * turning.moves(), by_x, by_z);
    const double scale = by_z.cwiseAbs().maxCoeff();
    EXPECT_GT(scale, 1e-2);
    for (Index k = 0; k < z0.size(); ++k) {
      Eigen::VectorXd z = z0;
      z[k] = z0[k] + 1e-6;
      const double above = energy(z);
      z[k] = z0[k] - 1e-6;
      // central differences of 1e-6: rounding 1e-10
      EXPECT_NEAR((above - energy(z)) / 2e-6, by_z[k], 1e-7 * scale) << k << " taper " << taper;
    }
  }
}

}  // namespace
}  // namespace wirepack
