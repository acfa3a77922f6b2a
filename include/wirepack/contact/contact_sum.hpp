#pragma once

#include <span>

#include "wirepack/contact/line_contact.hpp"
#include "wirepack/contact/neighbor_list.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// The line of an edge of a rod, with its free ends.
Line line_of(const RodState& state, Index edge);

/// Energy of all pairs; adds its derivative by the nodes (3 x N). The same as LineKernel::energy of
/// each pair, but four pairs at a time: first a test which of them touch, then the gradient of those
/// alone. Summed in the order of the pairs, those with a free end behind all others; pairs that do not
/// touch change no bit.
double add_contact_energy(const LineKernel& kernel, const RodState& state,
                          std::span<const EdgePair> pairs, Points& by_node);

}  // namespace wirepack
