#pragma once

#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Mean distance d_s of neighbouring strands in cross-sections (Stoop et al. 2011 read 2.81 a): planes
/// through the origin cut the wire; crossings at which it goes through the plane steeply, |t.n| > 0.7,
/// are joined by their Delaunay triangulation, and the mean is over the edges of the first shell: those
/// not above 1.5 times the distance of the nearest crossing of either end, which leaves out edges along
/// the convex hull and across an empty core.
struct StrandSpacing {
  double mean = 0;  ///< 0 when no three crossings of any plane are neighbours [length]
  Index pairs = 0;  ///< neighbours it is the mean of
};

/// Over the planes with these normals (3 x M).
StrandSpacing strand_spacing(const RodState& state, const Points& normals);
/// Over the six planes whose normals are the axes of an icosahedron.
StrandSpacing strand_spacing(const RodState& state);

/// The same of points in a plane (2 x M). For tens of points: tests all triangles.
StrandSpacing delaunay_spacing(const Eigen::Matrix2Xd& points);

}  // namespace wirepack
