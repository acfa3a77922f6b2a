#pragma once

#include <array>

#include "wirepack/contact/surface_slip.hpp"
#include "wirepack/rod/rod_params.hpp"

namespace wirepack {

/// Two points of the surfaces, followed with the material from a state in which they touch: the
/// SurfaceSlip of finite motions. Levers turn with their edges, so the offset between both points
///
///   W = sum w_i r_i + sum R_k c_k - origin,    u = (1 - n n^T) W
///
/// turns with the wire, and no rigid motion changes the length of u. The normal of two strands is
/// along -(R_1 c_1 + R_2 c_2). It turns by the mean of both edges' rotations, as it does where
/// strands of equal radius roll on each other. The wall and its normal do not move. On an edge that
/// grows as wire is fed, a point keeps its distance from the first node of the edge.
struct SurfaceAnchor {
  SurfaceSlip start;                ///< at the state of the anchor
  std::array<Vec3, 2> body_levers;  ///< c, in the frames of the edges
  std::array<double, 2> lengths{};  ///< rest lengths of the edges at the anchor
  Vec3 origin = Vec3::Zero();       ///< point of the wall; 0 for two strands
  bool on_wall = false;

  /// The slip of a state, and its derivatives.
  struct Slip {
    Vec3 u;                ///< first minus second surface, tangential
    SurfaceSlip map;       ///< d(|u|^2 / 2) = u . map.of(motions), the normal's turning included
    Vec3 by_inlet_length;  ///< explicit dW/d(inlet_rest_length)
  };
  Slip slip(const RodState& state, const RodParams& params) const;
};

/// Makes an anchor at points that are apart by `spring` (tangential, first minus second surface).
SurfaceAnchor strand_anchor(const RodState& state, const RodParams& params, Index first, double s,
                            Index second, double t, const Vec3& separation, const Vec3& spring);
SurfaceAnchor wall_anchor(const RodState& state, const RodParams& params, const Cavity& cavity,
                          Index node, const Vec3& spring);

}  // namespace wirepack
