#pragma once

#include "wirepack/dynamics/equation_of_motion.hpp"
#include "wirepack/dynamics/gear_integrator.hpp"

namespace wirepack::testing {

/// A wire on its way, with all that its motion needs.
struct MovingWire {
  MovingWire(const WireForces& forces, double density, const HeldUnknowns& held, RodState rod,
             double step)
      : motion(forces, density, held, rod), state(without_velocity(std::move(rod), step)) {}

  void advance(std::int64_t steps) {
    const auto set_rates = [this](const DynamicState& at, Rates& out) {
      motion.set_rates(at, friction, out);
    };
    for (std::int64_t k = 0; k < steps; ++k) gear_step(state, set_rates, rates);
  }
  void advance_to(double time) {
    advance(static_cast<std::int64_t>(std::round((time - state.time) / state.step)));
  }
  double mean_velocity(int component) const {
    double sum = 0;
    for (Index i = 0; i < state.rod.node_count(); ++i) sum += state.velocity(i)[component];
    return sum / static_cast<double>(state.rod.node_count());
  }

  EquationOfMotion motion;
  DynamicState state;
  FrictionMemory friction;
  Rates rates;
};

/// Friction of the paper's coefficients with springs of two thirds of the normal stiffness.
inline StickSlipLaw paper_friction() { return {0.2, 0.18, 2.0 / 3, 0.05}; }

}  // namespace wirepack::testing
