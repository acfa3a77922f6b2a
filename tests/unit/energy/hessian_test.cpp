#include <Eigen/Eigenvalues>
#include <cmath>
#include <gtest/gtest.h>

#include "wirepack/energy/energy_terms.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/open_wall_energy.hpp"
#include "wirepack/energy/self_contact_energy.hpp"
#include "wirepack/energy/spring_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/energy/wall_energy.hpp"

#include "../../support/sample_rods.hpp"

namespace wirepack {
namespace {

using testing::random_rod;

// The full matrix of a curvature model.
template <EnergyTerm Energy>
Eigen::MatrixXd model_of(const FrameChart& chart, Energy& energy, double exactness) {
  EnergyTerms{energy}.prepare(chart.reference());
  CurvatureModel model(chart, exactness);
  energy.add_curvature(chart.reference(), model);
  return Eigen::MatrixXd(model.lower_triangle(0, 0)).selfadjointView<Eigen::Lower>();
}

// Central differences of the gradient in the unknowns of the chart, by these moves.
template <EnergyTerm Energy>
Eigen::MatrixXd hessian_of(const FrameChart& chart, Energy& energy, const Eigen::VectorXd& moves) {
  EnergyTerms{energy}.prepare(chart.reference());
  Eigen::MatrixXd result(chart.size(), chart.size());
  RodState state = chart.reference();
  Gradient gradient;
  Eigen::VectorXd up, down;
  for (Index k = 0; k < chart.size(); ++k) {
    const auto gradient_at = [&](double move, Eigen::VectorXd& by_x) {
      Eigen::VectorXd x = chart.unknowns();
      x[k] += move;
      chart.set_state(x, state);
      set_zero(gradient, state);
      energy.add_gradient(state, gradient);
      chart.pull_back(state, gradient.node, gradient.frame, by_x);
    };
    gradient_at(moves[k], up);
    gradient_at(-moves[k], down);
    result.col(k) = (up - down) / (2 * moves[k]);
  }
  return result;
}

template <EnergyTerm Energy>
void expect_exact_model(const RodState& state, Energy& energy, const HeldUnknowns& held) {
  const FrameChart chart(state, held);
  const Eigen::MatrixXd hessian =
      hessian_of(chart, energy, Eigen::VectorXd::Constant(chart.size(), 1e-5));
  const double largest = hessian.cwiseAbs().maxCoeff();
  EXPECT_GT(largest, 1e-2);
  EXPECT_LT((model_of(chart, energy, 1) - hessian).cwiseAbs().maxCoeff(), 1e-7 * largest);
  // half-way between the squares and the Hessian
  const Eigen::MatrixXd mean = (model_of(chart, energy, 0) + hessian) / 2;
  EXPECT_LT((model_of(chart, energy, 0.5) - mean).cwiseAbs().maxCoeff(), 1e-7 * largest);
}

template <EnergyTerm Energy>
void expect_exact_model(const RodState& state, Energy& energy) {
  expect_exact_model(state, energy, HeldUnknowns::none(state));
}

std::vector<RodEnds> all_ends() {
  return {RodEnds{}, RodEnds{.first_clamped = true}, RodEnds{.last_clamped = true},
          RodEnds{.first_clamped = true, .last_clamped = true}, RodEnds{.closed = true}};
}

RodParams curved_params() {
  RodParams params;
  params.rest_darboux = Vec3(0.05, 0.1, -0.07);
  return params;
}

RodState bent_rod(const RodParams& params, const RodEnds& ends) {
  RodState state = random_rod(8, params, ends, 5);
  if (ends.closed) {
    for (Index i = 0; i < 8; ++i) {
      const double angle = 2 * pi * static_cast<double>(i) / 8;
      state.nodes.col(i) =
          Vec3(1.3 * std::cos(angle), 1.3 * std::sin(angle), 0.1 * std::sin(2 * angle));
    }
    state = make_rod(state.nodes, params, ends);
  } else {
    state.inlet_rest_length = 1.3;
  }
  return state;
}

TEST(Hessian, OfStretchIsExact) {
  for (const RodEnds& ends : all_ends()) {
    StretchEnergy energy(curved_params());
    expect_exact_model(bent_rod(curved_params(), ends), energy);
  }
}

TEST(Hessian, of_edges_pressed_below_half_their_length_is_exact) {
  StretchEnergy energy(curved_params());
  RodState state = bent_rod(curved_params(), RodEnds{});
  state.nodes *= 0.4;
  expect_exact_model(state, energy);
}

TEST(Hessian, OfBendAndTwistIsExactForAllEnds) {
  for (const RodEnds& ends : all_ends()) {
    JointEnergy energy(curved_params());
    expect_exact_model(bent_rod(curved_params(), ends), energy);
  }
}

// Moves of places and angles that change the energy alike.
Eigen::VectorXd small_moves(const FrameChart& chart, double length) {
  Eigen::VectorXd moves(chart.size());
  for (Index b = 0; b < chart.block_count(); ++b) {
    for (int c = 0; c < 4; ++c) {
      const Index u = chart.unknown(b, c);
      if (u >= 0) moves[u] = 1e-5 * (c < 3 ? length : 1);
    }
  }
  return moves;
}

TEST(Hessian, of_bend_and_twist_is_exact_for_edges_of_any_length) {
  for (const double length : {1e-9, 1e9}) {
    RodParams params = curved_params();
    params.radius *= length;
    params.edge_length *= length;
    params.rest_darboux /= length;
    JointEnergy energy(params);
    const RodState state = random_rod(8, params, {.last_clamped = true}, 5);
    const FrameChart chart(state, HeldUnknowns::none(state));
    const Eigen::VectorXd moves = small_moves(chart, length);
    const Eigen::MatrixXd hessian =
        moves.asDiagonal() * hessian_of(chart, energy, moves) * moves.asDiagonal();
    const Eigen::MatrixXd model =
        moves.asDiagonal() * model_of(chart, energy, 1) * moves.asDiagonal();
    const double largest = hessian.cwiseAbs().maxCoeff();
    EXPECT_GT(largest, 1e-12 * stiffness(params).bend / length);
    EXPECT_LT((model - hessian).cwiseAbs().maxCoeff(), 1e-7 * largest) << length;
  }
}

TEST(Hessian, OfBendingWithoutTorsionIsExact) {
  const RodParams params;
  for (const RodEnds& ends : all_ends()) {
    Stiffness without_twist = stiffness(params);
    without_twist.twist = 0;
    JointEnergy energy(params, without_twist);
    const RodState state = bent_rod(params, ends);
    HeldUnknowns held = HeldUnknowns::none(state);
    held.angle.assign(held.angle.size(), true);
    expect_exact_model(state, energy, held);
  }
}

TEST(Hessian, OfTheWallIsExact) {
  const RodParams params = curved_params();
  for (const Cavity& cavity : {Cavity{4}, ellipsoid(Vec3(4, 3, 5))}) {
    WallEnergy energy(params, cavity, 5);
    expect_exact_model(bent_rod(params, {.last_clamped = true}), energy);
  }
}

TEST(Hessian, of_the_wall_at_a_free_end_that_leans_is_exact) {
  const RodParams params = curved_params();
  Points nodes(3, 5);
  for (Index i = 0; i < 5; ++i) {
    nodes.col(i) = Vec3(0.3, -0.2, 9.3) - static_cast<double>(i) * Vec3(0.6, 0, 0.8);
  }
  const RodState state = make_rod(nodes, params, {.last_clamped = true});
  for (const Cavity& cavity : {Cavity{10}, ellipsoid(Vec3(8, 12, 10))}) {
    WallEnergy energy(params, cavity, 5);
    expect_exact_model(state, energy, HeldUnknowns::none(state));
  }
}

TEST(Hessian, of_springs_and_of_planes_and_cylinders_as_walls_is_exact) {
  const RodParams params = curved_params();
  const RodState state = bent_rod(params, {.last_clamped = true});
  SpringEnergy springs({{2, Vec3(1, 2, 3), 0.7}, {5, Vec3(-1, 0, 4), 2}});
  expect_exact_model(state, springs);
  const Vec3 node = state.nodes.col(4);
  OpenWallEnergy walls(params,
                       {PlaneWall{node - Vec3(0, 0, 0.4), Vec3::UnitZ()},
                        CylinderWall{node - Vec3(0.9, 1.2, 0), Vec3::UnitZ(), 1.8}},
                       5);
  expect_exact_model(state, walls);
}

// Two legs of one rod that press on each other in their middle, away from the ends.
RodState pressed_legs(double angle) {
  Points nodes(3, 24);
  for (Index i = 0; i < 10; ++i) {
    const double along = static_cast<double>(i) - 4.5;
    const double away = 0.03 * along * along;
    nodes.col(i) = rotation_about(Vec3::UnitY(), angle) * Vec3(along, -away, 0);
    nodes.col(23 - i) = Vec3(along + 0.3, 1.7 + away, 0.1 * std::sin(static_cast<double>(i)));
  }
  const Vec3 a = nodes.col(9), b = nodes.col(14);
  for (Index i = 10; i < 14; ++i) {
    const double u = static_cast<double>(i - 9) / 5;
    nodes.col(i) = a + u * (b - a) + std::sin(pi * u) * Vec3(6, 0, 0);
  }
  return make_rod(nodes, RodParams{});
}

TEST(Hessian, OfContactIsExactAtAnyAngle) {
  for (const double angle : {0.0, 0.3, 1.5}) {
    SelfContactEnergy energy(RodParams{}, ContactParams{});
    expect_exact_model(pressed_legs(angle), energy);
  }
}

// The second derivative of a gap has parts in the overlap, which is negative there.
TEST(Hessian, of_strands_that_nearly_touch_is_never_negative) {
  for (const double angle : {0.0, 0.3, 1.5}) {
    const RodState state = pressed_legs(angle);
    const auto contact_of = [&](double radius) {
      RodParams params;
      params.radius = radius;
      SelfContactEnergy energy(params, ContactParams{});
      energy.prepare(state);
      return energy;
    };
    const auto touches = [&](double radius) {
      Gradient gradient;
      set_zero(gradient, state);
      return double(contact_of(radius).add_gradient(state, gradient)) > 0;
    };
    double open = 0.5, touching = 1;
    while (touching - open > 1e-9) {
      const double middle = (open + touching) / 2;
      (touches(middle) ? touching : open) = middle;
    }
    SelfContactEnergy energy = contact_of(open * (1 - nearly_touching / 5));
    const FrameChart chart(state, HeldUnknowns::none(state));
    const Eigen::MatrixXd model = model_of(chart, energy, 1);
    const double largest = model.cwiseAbs().maxCoeff();
    EXPECT_GT(largest, 0) << "a contact that is about to form is in the model";
    EXPECT_EQ(model, model_of(chart, energy, 0)) << "by its squares alone";
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(model).eigenvalues()[0],
              -1e-12 * largest);
  }
}

TEST(Hessian, SquaresAreNotNegativeButTheHessianOfACompressedEdgeIs) {
  const RodParams params;
  StretchEnergy energy(params);
  Points nodes = Points::Zero(3, 2);
  nodes(2, 1) = 0.9 * params.edge_length;
  const RodState state = make_rod(nodes, params);
  const FrameChart chart(state, HeldUnknowns::none(state));
  const auto smallest = [&](double exactness) {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(model_of(chart, energy, exactness))
        .eigenvalues()[0];
  };
  EXPECT_GT(smallest(0), -1e-12);
  // compression over length, of both ends against each other
  const double compression = 0.1 * stiffness(params).stretch;
  EXPECT_NEAR(smallest(1), -2 * compression / nodes(2, 1), 1e-9);
}

}  // namespace
}  // namespace wirepack
