#pragma once

#include <vector>

#include "wirepack/contact/neighbor_list.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Pairs of edges of one wire that pass through each other (centreline through centreline) when
/// every node goes straight from its place in `before` to its place in `after`. A common rotation
/// about the origin makes no strands pass and is taken out first. A pair that passes and comes back
/// is not reported. A hit on a node is reported once.
///
/// Edge numbers of a pair differ by at least `separation` >= 2 (also around a closed rod). Nodes
/// that only one state has, at the inlet end, are ignored; closed rods must have equally many.
/// Pairs are sorted. Exact to about 1e-6 edge lengths, also for parallel and coplanar edges.
std::vector<EdgePair> passed_pairs(const RodState& before, const RodState& after, Index separation);

}  // namespace wirepack
