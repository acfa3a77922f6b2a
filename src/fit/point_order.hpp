#pragma once

#include <vector>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// The order in which points are listed, if it goes along a wire: hardly a sharp turn from point to
/// point, or between means of successive points, where they scatter by more than their distance.
/// Parts of a wire that are listed in another order or sense are joined at their nearest ends.
/// Empty when the list is in no order.
std::vector<Index> order_of_list(const Points& points);

/// Single points to which a list jumps and from which it jumps back, if it is in order without
/// them.
std::vector<Index> spikes_of_list(const Points& points);

/// The order of points along a wire, from one of its ends: a chain of nearest neighbours through
/// the means of small groups, large enough that scatter across the wire does not turn the chain
/// back. Empty when there is no such chain.
std::vector<Index> order_along_wire(const Points& points);

}  // namespace wirepack
