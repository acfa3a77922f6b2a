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

/// Memory of a contact with friction, for the next increment.
struct SlipMemory {
  EdgePair edges;   ///< two edges; or a node, and -1 for the wall
  Vec3 spring;      ///< from the second to the first of two points that were once in touch [length]
  double slid = 0;  ///< part of |u| beyond the spring's limit e in the last increment [length]
};

/// Work of an increment against friction.
struct SlipWork {
  double dissipated = 0;  ///< >= 0
  double stored = 0;      ///< in the springs of the contacts
};

/// Friction in a minimization: the rate-independent dissipation potential of one increment,
///
///   D = sum over contacts of k f(|u|),   f = u^2 / 2 below e,  e |u| - e^2 / 2 above,
///
/// u the slip of the surfaces at the material points that are in touch when the increment starts.
/// The normal forces N are those of the start. k = mu_s N / slip tolerance. A contact has e = slip
/// tolerance, so its friction is k e = mu_s N at most. If it slid by more than the slip tolerance
/// in the last increment, it has e = slip tolerance mu_d / mu_s, so its friction is mu_d N at most.
/// Slip beyond e is dissipated. Slip up to e stays in a spring that the next increment starts with,
/// so a contact that sticks does not creep.
class SlipPotential {
 public:
  static constexpr std::string_view name = "friction";
  SlipPotential(const RodParams& params, const Cavity& cavity, const FrictionParams& friction);

  /// Starts an increment at `state` with these contacts, forces of the wall on nodes (N), and the
  /// memory of the last increment. A last node that a clamp (the nozzle) holds does not rub on the
  /// wall.
  void start(const RodState& state, std::span<const SelfContact> touches,
             const Eigen::VectorXd& wall_forces, std::span<const SlipMemory> memory);
  /// Adds the contacts that have formed on the way from the start of the increment, `before`, to
  /// `now`, with their present forces. Each sticks from the point of a straight way at which it
  /// came into touch; from `before` on if its gap was closed there. Contacts handed on between
  /// neighbouring edges are old ones. A contact that has slid by more than `usual_slip` since
  /// `before` was missed. It sticks from `before` on, as the straight way says nothing about it.
  struct Joined {
    Index count = 0;
    bool missed = false;  ///< true for at least one of them
  };
  Joined join(const RodState& before, const RodState& now, std::span<const SelfContact> touches,
              const Eigen::VectorXd& wall_forces, double usual_slip);
  /// Makes the `count` contacts that joined last stick without a limit, as if glued.
  void hold_joined(Index count);
  /// Gives them the limits of friction that their present normal forces set; these are 0 where
  /// they do not touch.
  void release_joined(Index count, std::span<const SelfContact> touches,
                      const Eigen::VectorXd& wall_forces);

  Energy add_gradient(const RodState& state, Gradient& gradient) const;
  void add_curvature(const RodState& state, CurvatureModel& model) const;

  SlipWork work(const RodState& state) const;
  /// Memory for the next increment, sorted by contact.
  std::vector<SlipMemory> memory(const RodState& state) const;

 private:
  struct Contact {
    EdgePair edges;
    SurfaceAnchor anchor;
    double stiffness, limit;  ///< k, e
    double expected;          ///< |u| that the model of the Hessian reckons with
  };

  RodParams params_;
  Cavity cavity_;
  FrictionParams friction_;
  std::vector<Contact> contacts_;
};

}  // namespace wirepack
