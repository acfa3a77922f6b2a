#pragma once

#include <optional>

#include "wirepack/contact/cavity.hpp"
#include "wirepack/core/types.hpp"
#include "wirepack/rod/frame_chart.hpp"
#include "wirepack/rod/rod_params.hpp"
#include "wirepack/rod/rod_state.hpp"

namespace wirepack {

/// Rotation of the wire about its axis in the nozzle.
enum class TwistCondition { free, locked };

/// A straight nozzle: a clamp at a fixed place. The wire leaves it along -direction, since tangents
/// point from the tip to the nozzle.
struct Nozzle {
  Vec3 position;   ///< of the clamped node
  Vec3 direction;  ///< unit tangent of the wire in the nozzle
  TwistCondition twist = TwistCondition::free;
};

/// Where a nozzle is and points to. By default it is at the pole of the z axis, where a clamped
/// node just touches the wall (in a sphere at (0, 0, R - a)), and feeds along the inward normal.
struct NozzleOptions {
  TwistCondition twist = TwistCondition::free;
  std::optional<Vec3> position = std::nullopt;   ///< where it enters the cavity [length]
  std::optional<Vec3> direction = std::nullopt;  ///< in which it feeds; its length does not matter
  double depth = 0;                              ///< how far it reaches in from there [length]
};

/// Its clamp is at `position`: the depth is left out. The position is one at which a wire of this
/// radius fits into the cavity.
Nozzle nozzle_at_wall(const NozzleOptions& options, const Cavity& cavity, double wire_radius);

/// What the nozzle holds: the node at the clamp, and the rotation of its frame when locked.
HeldUnknowns held_by(const Nozzle& nozzle, const RodState& state);

/// A straight, untwisted wire of two edges at the nozzle, the last of this rest length.
RodState initial_wire(const Nozzle& nozzle, const RodParams& params, double inlet_rest_length);

}  // namespace wirepack
