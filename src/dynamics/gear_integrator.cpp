#include "wirepack/dynamics/gear_integrator.hpp"

namespace wirepack {

void begin_step(DynamicState& state) {
  state.time += state.step;
  state.rod.inlet_rest_length += state.feed_speed * state.step;
  gear_predict(state.nodes);
  gear_predict(state.spins);
  add_holonomy(state);
  follow_nodes(state);
}

void end_step(DynamicState& state, const Rates& rates) {
  gear_correct(state.nodes, rates.node, state.step);
  gear_correct(state.spins, rates.spin, state.step);
}

void start_accelerations(DynamicState& state, const Rates& rates) {
  state.nodes.col(2) = state.step * state.step / 2 * rates.node;
  state.spins.col(2) = state.step * state.step / 2 * rates.spin;
}

}  // namespace wirepack
