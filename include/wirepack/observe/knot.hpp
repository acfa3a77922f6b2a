#pragma once

#include <cstdint>
#include <string>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// What the Alexander polynomial D(t) of a closed curve says about its knot.
struct KnotType {
  /// "unknot", a prime knot of up to seven crossings ("3_1", "4_1", ...) or a sum of two of them
  /// ("3_1#4_1") with this polynomial; empty when none has it. Mirror images have the same one, as
  /// have some knots of eight crossings and more (8_20 and 3_1#3_1), and a few of eleven and more
  /// that of the unknot.
  std::string name;
  std::uint32_t determinant = 1;  ///< |D(-1)| modulo 2^31 - 1
  Index crossings = 0;            ///< of the diagram that was left after simplification
};

/// Of the closed polygon (3 x N). A knot left with more than 100,000 crossings has no name and the
/// determinant 0, which no knot has. Corners that nothing passes through are cut off first
/// (Koniaris & Muthukumar 1991; Taylor 2000); the rest is seen along the best of some directions,
/// and D is the determinant of its Alexander matrix modulo a prime, at -1, 2, 1/2, 3, 1/3. Products
/// D(t) D(1/t) do not depend on the diagram.
KnotType knot_type(const Points& closed_polygon);

/// An open wire with both ends led away from the origin, straight on, and joined far outside: how a
/// wire is closed through the nozzle (its last node), with its tip (the first) led out by the
/// shortest way. The tip's way may pass other strands; the closure is part of what "the knot of a
/// packing" means.
Points closed_outside(const Points& nodes);

}  // namespace wirepack
