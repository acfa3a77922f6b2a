#pragma once

#include "wirepack/energy/gradient.hpp"

namespace wirepack {

/// Force on each node (3 x N) that keeps a state as it is, from the gradient of all its energies:
/// of a held node what holds it, of a free one in equilibrium 0. It is the derivative by the node
/// alone, with the frames of its edges taken along without twist: dE/dr -+ (dE/d(spin) x t) / |e|
/// for the edges e that begin and end there.
Points reactions(const RodState& state, const Gradient& gradient);

}  // namespace wirepack
