#pragma once

#include "wirepack/core/types.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Writhe of a polygon: the Gauss integral 1/(4 pi) sum over pairs of edges of the solid angle
/// they span, exact for the polygon (Klenin & Langowski 2000, method 1a; the solid angles from
/// tangents of half angles, which keep all digits). Right-handed crossings count positive. A closed
/// polygon has an edge from the last node to the first; the writhe of an open one is not
/// topological. Cost N^2.
double writhe(const Points& nodes, bool closed);
double writhe(const RodState& state);

/// Writhe, and the same sum of absolute values: the number of crossings seen, mean over all
/// directions to look from (Freedman & He 1991; Buck & Simon 2012). Shared by the threads at hand.
struct CrossingSums {
  double writhe = 0, average_crossing_number = 0;
};
CrossingSums crossing_sums(const Points& nodes, bool closed);

/// Times two closed polygons wind around each other: half the signed crossings; whole to rounding.
double linking_number(const Points& first, const Points& second);

/// Twist of all joints in turns, clamps included; right-handed positive, whole turns as tracked.
double total_twist(const RodState& state);

/// Curve beside a closed rod, `distance` along the first axis of its frames (at a node: of the
/// frame half-way between those of its edges). For distances below any gap in the rod, the linking
/// number of rod and edge is total_twist + writhe (White 1969), a whole number when frames close.
Points ribbon_edge(const RodState& state, double distance);

}  // namespace wirepack
