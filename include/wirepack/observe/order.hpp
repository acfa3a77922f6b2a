#pragma once

#include "wirepack/core/types.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Nematic order of axes: the eigenvalues of Q = <(3 u u^T - 1) / 2>, largest first, which sum to
/// zero. All axes equal: 1, -1/2, -1/2; all in one plane: 1/4, 1/4, -1/2; isotropic: 0.
struct AxialOrder {
  Vec3 eigenvalues = Vec3::Zero();
  Vec3 director = Vec3::UnitZ();  ///< of the largest; its sign has no meaning

  double order() const { return eigenvalues[0]; }
};

/// Of unit vectors (3 x M); all zero when there are none.
AxialOrder axial_order(const Points& axes);

/// Mean of (3 (u.n)^2 - 1) / 2 for the unit vector n: 1 when all axes are along it, -1/2 when all
/// are normal to it. 0 when there are none.
double alignment(const Points& axes, const Vec3& direction);

/// Unit tangents of the edges (3 x E).
Points edge_tangents(const RodState& state);

/// Unit axes of the coils of an open rod (3 x M): for every node from which the wire goes on for at
/// least one turn, the axis of that turn. A turn is the shortest stretch along which the angles
/// between successive edges add up to 2 pi. Its axis is that of the area it encloses,
/// sum (r - r_mean) x dr, which is r x t averaged over the turn, made independent of the origin.
Points coil_axes(const RodState& state);

}  // namespace wirepack
