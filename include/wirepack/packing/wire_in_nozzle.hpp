#pragma once

#include <span>

#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/packing_model.hpp"

namespace wirepack {

/// A wire of this rest length through nodes (3 x N, from the tip to the nozzle) that ends in the
/// nozzle of a model. `frames` are those of its N - 1 edges; they lie along the edges, or are
/// carried there (carry_frames()). Without any, no joint is twisted. A nozzle that blocks rotation
/// has the frame of the start, a free one that of the last edge, untwisted. Throws InvalidInput
/// unless there are as many frames and the last edge has a rest length; NumericalFailure as
/// make_rod() does. Where the nodes end is not looked at.
RodState wire_in_nozzle(const PackingModel& model, const Points& nodes,
                        std::span<const Quat> frames, double inserted_length);

/// The wire of a saved frame, from where it may be fed, relaxed or measured: see equilibrate().
RodState wire_in_nozzle(const PackingModel& model, const PackingFrame& frame);

}  // namespace wirepack
