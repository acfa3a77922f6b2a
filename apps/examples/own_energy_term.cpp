// An energy term of one's own in a packing: a soft ball in the middle of the cavity, which the wire
// has to go round.
#include <algorithm>
#include <cstdio>
#include <exception>

#include <wirepack/packing/quasistatic_packing.hpp>

using namespace wirepack;

// Sum over nodes of k l / 2 (depth in the ball)^2, l the length that a node stands for.
struct BallEnergy {
  static constexpr std::string_view name = "ball";
  RodParams wire;
  double radius, stiffness;  // of the ball and the wire together; per length of wire

  Energy add_gradient(const RodState& state, Gradient& gradient) const {
    EnergySum energy;
    for (Index i = 0; i < state.node_count(); ++i) {
      const Vec3 r = state.nodes.col(i);
      const double depth = radius - r.norm(), length = node_length(state, wire, i);
      if (depth <= 0) continue;
      const double per_length = stiffness / 2 * depth * depth;
      energy.add(length * per_length);
      gradient.node.col(i) -= length * stiffness * depth * r.normalized();
      gradient.inlet_length += node_length_by_inlet(state, i) * per_length;
    }
    return energy.total();
  }

  // The depth squared is a square already, so this is its Gauss-Newton part.
  void add_curvature(const RodState& state, CurvatureModel& model) const {
    for (Index i = 0; i < state.node_count(); ++i) {
      const Vec3 r = state.nodes.col(i);
      if (r.norm() >= radius) continue;
      const CurvatureModel::NodePart by_node{i, -r.normalized()};
      model.add_square(stiffness * node_length(state, wire, i), {&by_node, 1});
    }
  }
};

int main() try {
  Scenario scenario = default_scenario(Setup::low_torsion, {10});
  scenario.stop.density = 0.05;
  const BallEnergy ball{scenario.wire, 5, scenario.wall_stiffness};
  QuasistaticPacking packing(scenario, {ball});
  std::optional<StopReason> stop;
  while (!stop) stop = packing.advance().stop;

  const Points& nodes = packing.progress().rod.nodes;
  const double nearest = nodes.colwise().norm().minCoeff();
  std::printf("phi = %.3f: the wire keeps %.2f off the centre of a ball of %.2f\n",
              packing.progress().last.packing_density, nearest, ball.radius);
  return *stop == StopReason::density && nearest > 0.9 * ball.radius ? 0 : 3;
} catch (const std::exception& error) {  // NumericalFailure: what is given here is valid
  std::fprintf(stderr, "own_energy_term: %s\n", error.what());
  return 4;
}
