#pragma once

#include "wirepack/feed/nozzle.hpp"
#include "wirepack/rod/rod_params.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Feeds wire: the rest length of the inlet edge grows by `arc_length`. The last nodes slide along
/// the wire, so that ten edges share the compression; the minimizer relaxes it. In the inlet edge
/// alone it would hold more energy than all the rest. `arc_length` is positive and at most an edge
/// length; nothing checks it. No node of a closed rod moves.
void insert(RodState& state, double arc_length);

/// Feeds one whole edge of wire (rest length edge_length) by sliding: a homogeneous wire that is
/// fed moves along itself. So every edge takes the place and the frame of the one ahead of it, and
/// the edge at the tip continues the curvature of the joint behind it. All but the tip stays in
/// equilibrium. The inlet edge keeps its length, so the force is always read at the same phase of
/// the mesh.
void slide_one_edge(RodState& state, const RodParams& params);

/// True if the inlet edge has grown to its longest rest length, and is to be split. The shorter the
/// new inlet edge, the less energy a split changes: one without length changes none.
bool split_is_due(const RodState& state, double longest);

/// Splits the inlet edge into an edge of rest length edge_length and a new, shorter inlet edge. The
/// new node lies on the curve through the neighbouring nodes (cubic Hermite, with the nozzle's
/// direction at the clamp). Frames share the twist out in proportion. Minimize again before
/// energies are compared.
void split_inlet(RodState& state, const Nozzle& nozzle, const RodParams& params);

}  // namespace wirepack
