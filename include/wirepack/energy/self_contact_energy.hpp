#pragma once

#include <string_view>
#include <vector>

#include "wirepack/contact/contact_sum.hpp"
#include "wirepack/contact/line_contact.hpp"
#include "wirepack/contact/neighbor_list.hpp"
#include "wirepack/energy/energy_term.hpp"

namespace wirepack {

/// How strands repel.
struct ContactParams {
  double stiffness =
      5;  ///< k per length of two parallel strands and per overlap [force / length^2]
  double excluded_arc_length = pi;  ///< neighbours along the wire nearer than this do not touch
};

/// Linear repulsion between strands, shared without bumps by the kernel of line_contact.hpp: the
/// force per length of two parallel strands is k overlap, the force of a crossing 2 a k overlap,
/// for any mesh.
class SelfContactEnergy {
 public:
  static constexpr std::string_view name = "contact";
  SelfContactEnergy(const RodParams& params, const ContactParams& contact);
  /// Makes a new neighbor list where the last two do not cover the state; returns whether.
  bool prepare(const RodState& state);
  Energy add_gradient(const RodState& state, Gradient& gradient) const;
  /// The same, and replaces `contacts` by what touches, in no particular but always the same order.
  Energy add_gradient(const RodState& state, Gradient& gradient,
                      std::vector<SelfContact>& contacts) const;
  void add_curvature(const RodState& state, CurvatureModel& model) const;
  /// What touches, sorted by pairs.
  std::vector<SelfContact> contacts(const RodState& state) const;

 private:
  ContactRange range_;
  LineKernel kernel_;
  double skin_;
  NeighborList list_;
  NeighborList list_before_;  // a step that was too long is taken back
};

}  // namespace wirepack
