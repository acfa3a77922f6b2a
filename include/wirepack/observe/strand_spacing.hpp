#pragma once

#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Neighbouring strands in cross-sections: planes through the origin cut the wire; crossings at
/// which it goes through the plane steeply, |t.n| > 0.7, are joined where they are neighbours of
/// the first shell: by an edge of their Delaunay triangulation that is not above 1.5 times the
/// distance of the nearest crossing of either end, which leaves out edges along the convex hull and
/// across an empty core.
struct StrandSpacing {
  /// Mean distance d_s in the plane, as Stoop et al. 2011 read 2.81 a; a plane that cuts parallel
  /// strands aslant sees them further apart. 0 when no three crossings of any plane are neighbours
  /// [length]
  double mean = 0;
  /// The same of the distances across the strands, without the part along their mean tangent
  /// [length]
  double across = 0;
  Index pairs = 0;  ///< neighbours both are means of
  /// Hexagonal order <|psi_6|> of crossings with three neighbours or more, psi_6 the mean of exp(6
  /// i angle) over them, seen along the strand (Nelson & Halperin 1979): 1 on a hexagonal lattice.
  double hexagonal_order = 0;
  Index ordered = 0;  ///< crossings it is the mean of
};

/// Over the planes with these normals (3 x M).
StrandSpacing strand_spacing(const RodState& state, const Points& normals);
/// Over the six planes whose normals are the axes of an icosahedron.
StrandSpacing strand_spacing(const RodState& state);

/// The same of points in a plane (2 x M), as strands normal to it.
StrandSpacing delaunay_spacing(const Eigen::Matrix2Xd& points);

}  // namespace wirepack
