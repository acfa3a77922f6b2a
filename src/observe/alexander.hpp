#pragma once

#include <cstdint>
#include <vector>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// Arithmetic modulo the prime 2^31 - 1.
inline constexpr std::uint64_t prime = 2147483647;
std::uint64_t inverse(std::uint64_t value);

/// One crossing of a knot diagram: an arc goes over, and below it one arc ends and the next begins.
struct Crossing {
  std::uint32_t over, incoming, outgoing;
  bool right_handed;
};

/// The crossings of a closed polygon seen along z, in the order in which it goes below.
std::vector<Crossing> knot_diagram(const Points& polygon);

/// |D(t)| of the Alexander matrix without its last row and column, modulo the prime; its sign, and
/// powers of t, depend on the diagram.
std::uint64_t alexander_polynomial(const std::vector<Crossing>& diagram, std::uint64_t t);

}  // namespace wirepack
