#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "wirepack/contact/cavity.hpp"
#include "wirepack/contact/friction_params.hpp"
#include "wirepack/energy/self_contact_energy.hpp"
#include "wirepack/feed/nozzle.hpp"
#include "wirepack/packing/units.hpp"
#include "wirepack/rod/rod_params.hpp"
#include "wirepack/solve/equilibrium.hpp"

namespace wirepack {

struct InsertionOptions {
  double increment = 0.5;      ///< wire fed between two equilibria [length]
  double perturbation = 2e-3;  ///< random displacement of the free nodes, over the wire radius,
      ///< at the start of each increment until the first coil exists; in time
      ///< one push to the side of the whole wire
};

/// The first limit that is reached ends the run; at least one is set.
struct StopLimits {
  std::optional<double> scaled_force;  ///< F R^2 / YI, mean over the last edge length fed
  std::optional<double> force;         ///< F / (Y a^2), the same
  std::optional<double> density;       ///< phi
  std::optional<double> length;        ///< inserted length [length]
  std::optional<std::int64_t> increments;
};

struct OutputOptions {
  double frame_every_density = 0.01;     ///< phi between saved frames
  double checkpoint_every_seconds = 30;  ///< the file is at most this old
};

/// How a run with inertia goes on in time. What is not set follows from the wire and the cavity
/// (see dynamics_values), as only ratios to the speed of sound c = sqrt(Y / rho) matter.
struct DynamicsOptions {
  std::optional<double> damping;          ///< rate g of the viscous forces [1 / time]
  std::optional<double> insertion_speed;  ///< [length / time]
  std::optional<double> time_step;        ///< "auto": from the stiffest mode [time]
};

/// Amplitudes of imperfections that the seed draws from uniform distributions (see drawn_setup), so
/// that runs with different seeds are independent.
struct ImperfectionOptions {
  double natural_curvature = 0;  ///< rest curvature of the wire, over 1 / R
  double nozzle_offset = 0;      ///< of the nozzle along the wall, over the wire radius
  double nozzle_tilt = 0;        ///< of the nozzle out of its direction [rad]
};

enum class Setup { low_torsion, high_torsion };
/// Energy minimization after each increment, or integration in time.
enum class Method { quasistatic, dynamic };

/// Everything that defines a run. The same scenario gives the same bits.
struct Scenario {
  Setup setup = Setup::low_torsion;
  Method method = Method::quasistatic;
  std::uint64_t seed = 1;
  RodParams wire;
  double density = 1;  ///< rho of the wire, for runs with inertia [mass / length^3]
  Cavity cavity;
  double wall_stiffness = 5;  ///< force per length of wire and per overlap [force / length^2]
  NozzleOptions nozzle;
  bool contact_enabled = true;
  ContactParams contact;
  InsertionOptions insertion;
  StopLimits stop;
  MinimizerOptions minimizer;
  FrictionParams friction;
  DynamicsOptions dynamics;
  ImperfectionOptions imperfection;
  OutputOptions output;
};

/// The scenario of the paper's setup in a cavity of radius R, every other value at its default:
/// low torsion is a straight wire free to rotate in the nozzle, high torsion a wire of rest
/// curvature 1 / (2 R) whose rotation is blocked. Edges are R / 10 long, R / 20 in high torsion
/// (whose force is so small that the mesh at the inlet shows sooner), but a/2 at least and 2 a at
/// most; increments are half an edge, stiffnesses of contacts are Y, and the run ends at
/// F R^2 / YI = 10. Runs with inertia have Coulomb friction, which multiplies the force, and end at
/// 30.
Scenario default_scenario(Setup setup, const Cavity& cavity, double wire_radius = 1,
                          double youngs_modulus = 5, Method method = Method::quasistatic);

/// Every impossible value as "key = value: what is allowed"; empty when the scenario is valid.
std::vector<std::string> problems(const Scenario& scenario);

/// Throws InvalidInput with all problems, a line each, unless there are none.
void require_valid(const Scenario& scenario);

inline Units units_of(const Scenario& scenario) {
  return {scenario.wire.radius, scenario.wire.youngs_modulus, scenario.density,
          scenario.cavity.radius, stiffness(scenario.wire).bend};
}

/// YI / R^2: forces over it are what stop.scaled_force means; stop.force is over Y a^2.
inline double force_unit(const Scenario& scenario) { return units_of(scenario).scaled_force(); }

/// Inserted length by which a first coil has formed; until then the straight wire is perturbed.
inline double first_coil_length(const Cavity& cavity) { return 2 * (1 + pi) * cavity.radius; }

}  // namespace wirepack
