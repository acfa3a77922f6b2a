#pragma once

#include <cmath>

#include "wirepack/core/random.hpp"

#include "elastic_rest.hpp"

namespace wirepack::testing {

/// A rod of length 100, YI = 1.345, GJ = 0.789, its clamped ends 27 turns and 97 apart: PyElastica
/// examples/HelicalBucklingCase.
struct LocalisedHelix {
  double moment;          ///< about the axis
  double tension;         ///< along the axis
  double envelope_error;  ///< root mean square of the error of 1 - cos(phi), over its own
  double centre;          ///< of the bump, from the middle of the rod
};

/// Solution for the infinite rod (van der Heijden, Neukirch, Goss, Thompson 2003):
/// (cos phi - c0) / (1 - c0) = tanh^2(s / s*), s* = (2 B / M) sqrt((1 + c0) / (1 - c0)).
struct ExactEnvelope {
  static constexpr double moment = 1.3253831, tension = 0.3901836;
  static constexpr double c0 = 0.67363826, width = 4.59613;
  static double cosine(double s) { return c0 + (1 - c0) * std::pow(std::tanh(s / width), 2); }
};

inline LocalisedHelix localised_helix(Index edges) {
  constexpr double length = 100, slack = 3, turns = 27;
  RodParams params = unit_rod(edges, length, 4e8, 1.345 / 0.789 - 1);
  params.youngs_modulus *= 1.345;
  // A bump in the middle, of the right slack but neither of the right shape nor wave number.
  constexpr double bump_width = 6, bump_wave_number = 0.4;
  double low = 0, high = pi / 2;
  const auto tangent_at = [&](double s, double tilt) {
    const double angle = tilt / std::cosh(s / bump_width);
    const double azimuth = bump_wave_number * s;
    return Vec3(std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth),
                std::cos(angle));
  };
  const auto nodes_at = [&](double tilt) {
    Points nodes = Points::Zero(3, edges + 1);
    for (Index j = 0; j < edges; ++j) {
      const double s = (static_cast<double>(j) + 0.5) * params.edge_length - length / 2;
      nodes.col(j + 1) = nodes.col(j) + params.edge_length * tangent_at(s, tilt);
    }
    return nodes;
  };
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (nodes_at(middle)(2, edges) > length - slack ? low : high) = middle;
  }
  Points nodes = nodes_at(low);
  Random random(5);
  for (Index i = 1; i < edges; ++i) {
    for (int c = 0; c < 2; ++c) nodes(c, i) += 1e-6 * random.symmetric();
  }
  // ends on the axis
  const Vec3 miss = nodes.col(edges) - Vec3(0, 0, length - slack);
  for (Index i = 1; i <= edges; ++i) {
    nodes.col(i) -= miss * static_cast<double>(i) / static_cast<double>(edges);
  }
  RodState state = make_rod(nodes, params, {.first_clamped = true, .last_clamped = true});
  twist_uniformly(state, turns * 2 * pi);
  for (const Index clamp : {state.first_clamp_frame(), state.last_clamp_frame()}) {
    Quat& frame = state.frames[static_cast<std::size_t>(clamp)];
    frame = transport(third_axis(frame), Vec3::UnitZ()) * frame;
  }
  // After whole turns the last clamp stands like the first; the bump alone has turned it a little.
  Quat& last = state.frames[static_cast<std::size_t>(state.last_clamp_frame())];
  const Quat excess =
      last * state.frames[static_cast<std::size_t>(state.first_clamp_frame())].conjugate();
  const double turn = nearest_turn(2 * std::atan2(excess.z(), excess.w()), 0);
  last = rotation_about(Vec3::UnitZ(), -turn) * last;
  state.twist_guide.back() -= turn;
  HeldUnknowns held = HeldUnknowns::none(state);
  held.hold_node(0);
  held.hold_node(edges);
  hold_angle(held, state.first_clamp_frame());
  hold_angle(held, state.last_clamp_frame());
  solver_rest(state, held, params, {}, {1e-6, 1e-6});

  const Reactions reaction = reactions(state, params);
  LocalisedHelix result{};
  result.tension = reaction.force(2, edges);
  result.moment = reaction.moment(2, state.last_clamp_frame());
  // Its place along the rod is all but free (exp(-50 / s*)), so the exact one is put at the same.
  Eigen::VectorXd arc(edges), bump(edges);
  for (Index j = 0; j < edges; ++j) {
    arc[j] = (static_cast<double>(j) + 0.5) * params.edge_length - length / 2;
    bump[j] = 1 - tangent(state, j).z();
  }
  const double centre = arc.dot(bump) / bump.sum();
  double difference = 0, size = 0;
  for (Index j = 0; j < edges; ++j) {
    const double exact = 1 - ExactEnvelope::cosine(arc[j] - centre);
    difference += std::pow(bump[j] - exact, 2);
    size += std::pow(exact, 2);
  }
  result.envelope_error = std::sqrt(difference / size);
  result.centre = centre;
  return result;
}

}  // namespace wirepack::testing
