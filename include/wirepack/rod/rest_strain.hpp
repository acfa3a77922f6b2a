#pragma once

#include "wirepack/core/types.hpp"
#include "wirepack/rod/rod_params.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Integrated strain of the stress-free joint at a node: what joint_strain() (rod_strain.hpp) is
/// compared with. The joint stands for the wire from the middle of one of its edges to the middle
/// of the other. Node 0 is the tip, so joint i stays at the material arc i * edge_length, and only
/// the joints at the inlet edge change with its length.
///
/// A uniform rest_darboux gives node_length * k0. A reference shape adds the integral of its k0
/// over that part of the wire, seen from frames that do not twist along the unstressed wire:
/// bending is turned by the twist phi(s) = int k3 ds up to the middle of the part, and the rest
/// twist is 0. A round wire has the same energy in any material frame. These frames are chosen
/// because a nozzle that blocks rotation holds them still: the wire behind it has no torsion, so
/// fed wire keeps its angle about the axis. The direction in which it wants to bend enters turned
/// by phi.
Vec3 rest_strain(const RodState& state, const RodParams& params, Index node);

/// d(rest_strain) / d(inlet_rest_length).
Vec3 rest_strain_by_inlet(const RodState& state, const RodParams& params, Index node);

/// True if the stress-free wire is known to be straight and without twist.
bool is_straight(const RodParams& params);

}  // namespace wirepack
