#pragma once

#include <span>
#include <vector>

#include "wirepack/contact/line_contact.hpp"
#include "wirepack/contact/neighbor_list.hpp"
#include "wirepack/core/energy.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// The line of an edge of a rod, with its free ends.
Line line_of(const RodState& state, Index edge);

/// A touch of two edges with the force it carries.
struct SelfContact {
  EdgePair edges;
  LineContact line;
  double overlap;  ///< 2 a - distance [length]
  double force;    ///< on each strand, along the separation [force]
};

/// Energy of all pairs; adds its derivative by the nodes (3 x N). The same as LineKernel::energy of
/// each pair, but four pairs at a time. Summed in the order of the pairs, those with a free end
/// behind all others; pairs that do not touch change no bit.
Energy add_contact_energy(const LineKernel& kernel, const RodState& state,
                          std::span<const EdgeFour> pairs, Points& by_node);
/// The same, and replaces `touching` by the pairs that touch, in the order of the sum.
Energy add_contact_energy(const LineKernel& kernel, const RodState& state,
                          std::span<const EdgeFour> pairs, Points& by_node,
                          std::vector<SelfContact>& touching);

}  // namespace wirepack
