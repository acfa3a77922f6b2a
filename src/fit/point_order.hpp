#pragma once

#include <vector>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// The order of points along a wire, from one of its ends: a chain of nearest neighbours through the
/// means of small groups, large enough that scatter across the wire does not turn the chain back.
/// Empty when there is no such chain.
std::vector<Index> order_along_wire(const Points& points);

}  // namespace wirepack
