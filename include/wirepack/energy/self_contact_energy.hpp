#pragma once

#include <string_view>
#include <vector>

#include "wirepack/contact/contact_sum.hpp"
#include "wirepack/contact/line_contact.hpp"
#include "wirepack/contact/neighbor_list.hpp"
#include "wirepack/energy/energy_term.hpp"

namespace wirepack {

/// Repulsion between strands.
struct ContactParams {
  double stiffness =
      5;  ///< k per length of two parallel strands and per overlap [force / length^2]
  double excluded_arc_length = pi;  ///< neighbours along the wire nearer than this do not touch
};

/// Linear repulsion between strands. The force per length of two parallel strands is k overlap, the
/// force of a crossing at a right angle 2 a k overlap, on any mesh. The kernel of line_contact.hpp
/// shares it out among the edges without bumps. Strands that cross at less than 60 degrees touch
/// along a length, as parallel ones do: their force grows faster than the overlap, and with finer
/// meshes (method.md).
class SelfContactEnergy {
 public:
  static constexpr std::string_view name = "contact";
  SelfContactEnergy(const RodParams& params, const ContactParams& contact);
  /// Makes a new neighbor list if neither of the last two covers the state; returns whether it did.
  bool prepare(const RodState& state);
  Energy add_gradient(const RodState& state, Gradient& gradient) const;
  /// The same, and replaces `contacts` by the pairs that touch, unsorted but always in the same
  /// order.
  Energy add_gradient(const RodState& state, Gradient& gradient,
                      std::vector<SelfContact>& contacts) const;
  void add_curvature(const RodState& state, CurvatureModel& model) const;
  /// The pairs that touch, sorted.
  std::vector<SelfContact> contacts(const RodState& state) const;

 private:
  ContactRange range_;
  LineKernel kernel_;
  double skin_;
  NeighborList list_;
  NeighborList list_before_;  // serves again when too long a step is taken back
};

}  // namespace wirepack
