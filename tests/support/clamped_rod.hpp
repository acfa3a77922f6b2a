#pragma once

#include "wirepack/rod/frame_chart.hpp"
#include "wirepack/rod/rod_state.hpp"

#include "sample_rods.hpp"

namespace wirepack::testing {

struct HeldRod {
  RodState rod;
  HeldUnknowns held;
};

/// Straight along z from the origin, in edges of their rest length. Clamps at its ends are held.
inline HeldRod clamped_rod(Index edges, const RodParams& params, RodEnds ends) {
  const double length = params.edge_length * static_cast<double>(edges);
  RodState rod = make_rod(straight_nodes(edges, length), params, ends);
  HeldUnknowns held = HeldUnknowns::none(rod);
  const auto hold = [&](Index node, Index frame) {
    held.hold_node(node);
    held.angle[static_cast<std::size_t>(frame)] = true;
  };
  if (ends.first_clamped) hold(0, rod.first_clamp_frame());
  if (ends.last_clamped) hold(edges, rod.last_clamp_frame());
  return {std::move(rod), std::move(held)};
}

}  // namespace wirepack::testing
