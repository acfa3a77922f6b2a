#include "wirepack/dynamics/equation_of_motion.hpp"

#include <algorithm>
#include <utility>

#include "wirepack/dynamics/stick_limit.hpp"

namespace wirepack {

EquationOfMotion::EquationOfMotion(WireForces forces, double density, HeldUnknowns held,
                                   const RodState& rod)
    : forces_(std::move(forces)),
      stretch_(forces_.wire),
      joints_(forces_.wire, forces_.stiffness),
      loads_(forces_.wire, forces_.loads),
      inertia_(lumped_inertia(rod, forces_.wire, density, held)) {
  if (forces_.cavity) wall_.emplace(forces_.wire, *forces_.cavity, forces_.wall_stiffness);
  if (forces_.contact) contact_.emplace(forces_.wire, *forces_.contact);
}

void EquationOfMotion::resize(const RodState& rod, HeldUnknowns held) {
  inertia_ = lumped_inertia(rod, forces_.wire, inertia_.density, held);
}

void EquationOfMotion::set_rates(const DynamicState& state, FrictionMemory& memory, Rates& rates) {
  const RodState& rod = state.rod;
  update_inlet(inertia_, rod, forces_.wire);
  set_zero(gradient_, rod);
  set_motion(state, motion_);
  flow_ = EnergyFlow{};
  flow_.potential = stretch_.add_gradient(rod, gradient_) + joints_.add_gradient(rod, gradient_) +
                    loads_.add_gradient(rod, gradient_);
  if (wall_) flow_.potential += wall_->add_gradient(rod, gradient_);
  if (contact_) {
    contact_->prepare(rod);
    flow_.potential += contact_->add_gradient(rod, gradient_, contacts_);
  }
  flow_.injection_force = gradient_.inlet_length;
  if (forces_.friction) add_friction_of(state, memory);
  wirepack::set_rates(state, motion_, inertia_, gradient_, rates);
  if (forces_.damping > 0) {
    const DampingPower power = add_damping(forces_.damping, state, motion_, inertia_, rates);
    flow_.viscous = power.dissipated;
    flow_.medium = power.carried;
  }
  flow_.kinetic = kinetic_energy(state, inertia_);
  if (state.feed_speed != 0) {
    const double mass_per_length = inertia_.mass_per_length(forces_.wire);
    for (Index i = rod.node_count() - 2; i < rod.node_count(); ++i) {
      flow_.injection_force += mass_per_length * node_length_by_inlet(rod, i) / 2 *
                               motion_.velocity.col(i).squaredNorm();
    }
    flow_.feed = state.feed_speed * flow_.injection_force;
  }
}

void EquationOfMotion::add_friction_of(const DynamicState& state, FrictionMemory& memory) {
  const RodState& rod = state.rod;
  const double stiffest = std::max(forces_.cavity ? forces_.wall_stiffness : 0,
                                   forces_.contact ? forces_.contact->stiffness : 0);
  require_calm_sticking(*forces_.friction, stiffest / inertia_.mass_per_length(forces_.wire),
                        state.step);
  const Index last = rod.node_count() - 1;
  // Wire moves where it enters, although the clamp does not.
  const Vec3 fed = -state.feed_speed * forces_.nozzle_direction;
  const Vec3 clamped = motion_.velocity.col(last);
  if (state.feed_speed != 0) motion_.velocity.col(last) = fed;
  const Vec3 others_at_clamp = gradient_.node.col(last);
  const auto add = [&](std::vector<StickAnchor>& anchors) {
    const FrictionReport report =
        add_friction(*forces_.friction, touches_, motion_, state.step, anchors, gradient_);
    flow_.friction -= report.power;
    flow_.stick += report.stored;
  };

  touches_.clear();
  if (contact_) {
    const auto by_pair = [](const SelfContact& a, const SelfContact& b) {
      return std::pair(a.edges.first, a.edges.second) < std::pair(b.edges.first, b.edges.second);
    };
    // two sorted parts: pairs with a free end come last
    const auto middle = std::is_sorted_until(contacts_.begin(), contacts_.end(), by_pair);
    std::inplace_merge(contacts_.begin(), middle, contacts_.end(), by_pair);
    for (const SelfContact& contact : contacts_) {
      const auto [first, second] = contact.edges;
      const LineContact& line = contact.line;
      touches_.push_back({first, second,
                          strand_slip(rod, first, line.s, second, line.t, line.separation),
                          contact.force, line.stiffness});
    }
  }
  add(memory.strands);

  touches_.clear();
  if (wall_) {
    const bool has_nozzle = rod.ends.last_clamped;
    for (Index i = 0; i < rod.node_count() - (has_nozzle ? 1 : 0); ++i) {
      const double overlap = -wall_gap(*forces_.cavity, rod.nodes.col(i), forces_.wire.radius);
      if (overlap <= 0) continue;
      const double stiffness = wall_->stiffness(rod, i);
      touches_.push_back({i, -1, wall_slip(rod, i, forces_.wire.radius, *forces_.cavity),
                          stiffness * overlap, stiffness});
    }
  }
  add(memory.wall);

  if (state.feed_speed != 0) {
    // minus the force of friction on the material that enters
    const Vec3 held = gradient_.node.col(last) - others_at_clamp;
    flow_.injection_force += held.dot(fed) / state.feed_speed;
    motion_.velocity.col(last) = clamped;
  }
}

}  // namespace wirepack
