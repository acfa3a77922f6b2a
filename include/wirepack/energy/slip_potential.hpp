#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "wirepack/contact/cavity.hpp"
#include "wirepack/contact/friction_params.hpp"
#include "wirepack/contact/surface_anchor.hpp"
#include "wirepack/energy/energy_term.hpp"
#include "wirepack/energy/self_contact_energy.hpp"

namespace wirepack {

/// What a contact with friction hands on to the next increment.
struct SlipMemory {
  EdgePair edges;   ///< of two strands; a node and -1: with the wall
  Vec3 spring;      ///< from the second to the first of two points that were once in touch [length]
  double slid = 0;  ///< slip of the last increment beyond what the spring gives way [length]
};

/// What an increment has done against friction.
struct SlipWork {
  double dissipated = 0;  ///< >= 0
  double stored = 0;      ///< in the springs of the contacts
};

/// Friction in a minimization: the rate-independent dissipation potential of one increment,
///
///   D = sum over contacts of k f(|u|),   f = u^2 / 2 below e,  e |u| - e^2 / 2 above,
///
/// u the slip of the surfaces at the material points that are in touch when the increment starts.
/// The normal forces N are those of the start. k = mu_s N / slip tolerance, and e = slip tolerance,
/// so a contact is held by up to k e = mu_s N; where it slid in the last increment, by more than
/// the slip tolerance, e = slip tolerance mu_d / mu_s, and it is held by up to mu_d N. What u has
/// gone beyond e is dissipated, the rest is kept in a spring that the next increment starts with,
/// so what rests does not creep.
class SlipPotential {
 public:
  static constexpr std::string_view name = "friction";
  SlipPotential(const RodParams& params, const Cavity& cavity, const FrictionParams& friction);

  /// An increment starts at `state` with these contacts, forces of the wall on nodes (N), and what
  /// the last increment handed on. Every node but the last, which the nozzle holds, is held by the
  /// wall.
  void start(const RodState& state, std::span<const SelfContact> touches,
             const Eigen::VectorXd& wall_forces, std::span<const SlipMemory> memory);
  /// Adds the contacts that have formed on the way from the start of the increment, `before`, to
  /// `now`, with the forces that they have now: each is held from where it came into touch, if the
  /// way was straight; from `before` on if it nearly touched there. Contacts handed on between
  /// neighbouring edges are old ones. One that has slid by more than `usual_slip` since then was
  /// missed, its way says nothing: it is held from `before`.
  struct Joined {
    Index count = 0;
    bool missed = false;  ///< one of them
  };
  Joined join(const RodState& before, const RodState& now, std::span<const SelfContact> touches,
              const Eigen::VectorXd& wall_forces, double usual_slip);
  /// Holds the `count` contacts that joined last without a limit, as if glued.
  void hold_joined(Index count);
  /// Lets them slip by the normal forces that they have come to by now; 0 where they do not touch.
  void release_joined(Index count, std::span<const SelfContact> touches,
                      const Eigen::VectorXd& wall_forces);

  Energy add_gradient(const RodState& state, Gradient& gradient) const;
  void add_curvature(const RodState& state, CurvatureModel& model) const;

  SlipWork work(const RodState& state) const;
  /// What the next increment is to know, sorted by contact.
  std::vector<SlipMemory> memory(const RodState& state) const;

 private:
  struct Contact {
    EdgePair edges;
    SurfaceAnchor anchor;
    double stiffness, limit;  ///< k, e
    double expected;          ///< |u| to reckon with
  };

  RodParams params_;
  Cavity cavity_;
  FrictionParams friction_;
  std::vector<Contact> contacts_;
};

}  // namespace wirepack
