#pragma once

#include "elastic_rest.hpp"
#include "sample_rods.hpp"

namespace wirepack::testing {

/// A straight rod clamped along z, bent by a tip moment about x that grows in eight steps, so that
/// the angle of its end is followed past a half turn. It is kept in its plane, which it would
/// leave: the potential of a moment with a fixed axis has no torque that holds it there.
inline RodState bent_by_tip_moment(const RodParams& params, Index edges, double moment) {
  const double length = params.edge_length * static_cast<double>(edges);
  RodState state = make_rod(straight_nodes(edges, length), params, {.first_clamped = true});
  HeldUnknowns held = HeldUnknowns::none(state);
  held.hold_node(0);
  hold_coordinate(held, 0);
  held.angle.assign(held.angle.size(), true);  // in the plane nothing twists
  EdgeMoment load{edges - 1, Vec3::UnitX(), 0, state.frames[static_cast<std::size_t>(edges - 1)]};
  const double bend = stiffness(params).bend;
  for (int step = 1; step <= 8; ++step) {
    load.moment = moment * step / 8;
    Loads loads;
    loads.moments.push_back(load);
    rest(state, held, params, loads, {1e-7 * bend / (length * length), 1e-8 * bend / length});
    load.angle_guide = load.angle(state);
  }
  return state;
}

}  // namespace wirepack::testing
