#pragma once

#include <optional>
#include <vector>

#include "wirepack/dynamics/damping.hpp"
#include "wirepack/dynamics/friction.hpp"
#include "wirepack/dynamics/inertia.hpp"
#include "wirepack/energy/joint_energy.hpp"
#include "wirepack/energy/load_energy.hpp"
#include "wirepack/energy/self_contact_energy.hpp"
#include "wirepack/energy/stretch_energy.hpp"
#include "wirepack/energy/wall_energy.hpp"

namespace wirepack {

/// Forces that move a wire. Terms that are not set do not act.
struct WireForces {
  RodParams wire;
  Stiffness stiffness = wirepack::stiffness(wire);  ///< of the joints; see JointEnergy
  std::optional<Cavity> cavity;
  double wall_stiffness = 5;  ///< [force / length^2]
  std::optional<ContactParams> contact;
  std::optional<StickSlipLaw> friction;  ///< of all contacts, but not in the nozzle
  double damping = 0;                    ///< rate of the viscous forces [1 / time]
  Loads loads;
  Vec3 nozzle_direction = Vec3::UnitZ();  ///< fed wire enters against it
};

/// Memory of the contacts, between strands and with the wall; sorted.
struct FrictionMemory {
  std::vector<StickAnchor> strands, wall;
};

/// Energies and powers at one time.
struct EnergyFlow {
  double potential = 0;  ///< elastic, contact, wall, loads
  double kinetic = 0;
  double stick = 0;            ///< energy of the springs of friction
  double feed = 0;             ///< power of the insertion
  double injection_force = 0;  ///< power of the insertion over its speed
  double friction = 0;         ///< power that friction takes from the wire
  double viscous = 0;          ///< power that the viscous forces take from the wire, >= 0
  double medium = 0;           ///< power of the viscous medium, which moves with the fed wire

  double stored() const { return potential + kinetic + stick; }
};

/// Accelerations of a wire from the same energy terms and the same contacts as minimizations, with
/// inertia, friction and damping. The injection force is a sum of three: the explicit dE/dL; the
/// friction of the inlet edge that its clamped end holds; half the squared velocity of the first
/// free node times the mass that it gains per fed length. With it
///     feed + medium = d(potential + kinetic)/dt + friction + viscous.
class EquationOfMotion {
 public:
  EquationOfMotion(WireForces forces, double density, HeldUnknowns held, const RodState& rod);

  /// Sets the accelerations at a state, and advances the memory of friction by the state's step.
  void set_rates(const DynamicState& state, FrictionMemory& memory, Rates& rates);
  /// Energies and powers at the last set_rates().
  const EnergyFlow& flow() const { return flow_; }
  const Inertia& inertia() const { return inertia_; }
  /// Adapts to a rod that may have gained edges at the nozzle.
  void resize(const RodState& rod, HeldUnknowns held);

 private:
  void add_friction_of(const DynamicState& state, FrictionMemory& memory);

  WireForces forces_;
  StretchEnergy stretch_;
  JointEnergy joints_;
  std::optional<WallEnergy> wall_;
  std::optional<SelfContactEnergy> contact_;
  LoadEnergy loads_;
  Inertia inertia_;
  EnergyFlow flow_;
  // buffers that every step uses again
  Gradient gradient_;
  WireMotion motion_;
  std::vector<SelfContact> contacts_;
  std::vector<Touch> touches_;
};

}  // namespace wirepack
