#pragma once

#include <span>
#include <vector>

#include "wirepack/contact/surface_slip.hpp"
#include "wirepack/dynamics/dynamic_state.hpp"
#include "wirepack/energy/gradient.hpp"

namespace wirepack {

/// Stick-slip law: a tangential spring with a limit, after Cundall and Strack (1979). Where
/// surfaces stick, f = -k_t xi - g_t v as long as |f| <= mu_s times the normal force; else they
/// slide with f = mu_d times the normal force along that, and the spring is shortened to match;
/// they stick again when the trial force is below mu_d times the normal force. k_t and g_t share
/// the weight with which a pair of edges takes part in a meeting, so that nothing jumps as strands
/// slide along each other.
struct StickSlipLaw {
  double static_coefficient;   ///< mu_s
  double dynamic_coefficient;  ///< mu_d
  double stiffness_ratio;      ///< k_t over the normal stiffness
  double relaxation_time;      ///< g_t / k_t [time]
};

/// Two surfaces that touch: strands (edges first < second), or wire and wall (a node, and -1).
struct Touch {
  Index first, second;
  SurfaceSlip slip;
  double normal_force;  ///< >= 0
  double stiffness;     ///< of the normal force, by overlap
};

/// What a contact remembers.
struct StickAnchor {
  Index first, second;
  Vec3 spring;  ///< xi: tangential displacement since it sticks [length]
  double normal_force;
  bool sliding;
};

struct FrictionReport {
  double power = 0;   ///< of friction on all surfaces, <= 0 but for what springs give back
  double stored = 0;  ///< energy of the springs
};

/// Adds friction (minus the forces and moments) to a gradient and moves the memory on by a step.
/// `touches` and `memory` are sorted by (first, second). A contact of strands that is new takes
/// over the spring of the strongest one between neighbouring edges (first and second each at most
/// one off): the meeting has moved on to the next edges. Memory of contacts that have opened is
/// dropped.
FrictionReport add_friction(const StickSlipLaw& law, std::span<const Touch> touches,
                            const WireMotion& motion, double step, std::vector<StickAnchor>& memory,
                            Gradient& gradient);

}  // namespace wirepack
