#pragma once

#include <vector>

#include "wirepack/energy/self_contact_energy.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// One place where two strands touch: pairs of edges that hang together. The contact kernel shares
/// a crossing among some pairs of neighbouring edges, and strands side by side touch along many, so
/// that pairs are a matter of the mesh, and patches are not.
struct ContactPatch {
  Index pairs = 0;
  double force = 0;  ///< sum over its pairs [force]
  double angle = 0;  ///< between the strands, 0 ... pi / 2; mean over the pairs, weighted by force
};

/// Pairs (i, j) and (k, l) hang together when |i - k| <= 1 and |j - l| <= 1. Pairs without force
/// count as open. Sorted by the first pair of each.
std::vector<ContactPatch> contact_patches(const RodState& state,
                                          const std::vector<SelfContact>& contacts);

}  // namespace wirepack
