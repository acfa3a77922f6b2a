#pragma once

#include "wirepack/core/types.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// How ordered the coils of an open rod are, and how far its tip has turned.
struct CoilReport {
  double axis_order = 0;      ///< nematic order of coil_axes(): a spool 1, disordered coils 0
  double feed_alignment = 0;  ///< mean of (3 cos^2 - 1) / 2 of the coil axes with the feed
  Index reversals = 0;        ///< changes of the sense in which loops run around the common axis
  double twist = 0;           ///< of all joints [turns]
  double writhe = 0;
  double average_crossing_number = 0;

  /// Turns of the tip about the wire's axis against the nozzle: twist, and what writhing turns.
  double tip_rotation() const { return twist + writhe; }
};

/// Of a wire that is fed along the unit vector `feed`. Axes within 60 degrees of the common axis
/// count as loops in one sense or the other. Zeros where the wire has not made a turn yet.
CoilReport coil_report(const RodState& state, const Vec3& feed);

}  // namespace wirepack
