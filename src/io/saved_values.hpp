#pragma once

#include <vector>

#include "wirepack/packing/history.hpp"
#include "wirepack/packing/packing_frame.hpp"
#include "wirepack/packing/packing_progress.hpp"

namespace wirepack {

// What a file holds is looked at like what a configuration says: a checksum only tells that
// somebody has written it. All numbers are finite already. Each throws FileError.

/// Lists that fit together, edges that are there, positive lengths, parts between none and all.
void check_progress(const PackingProgress& progress);
/// Increments 1 ... n of a wire that gets longer.
void check_history(const std::vector<HistoryRow>& rows);
/// Lists that fit together, contacts of edges that are there.
void check_frame(const PackingFrame& frame);

}  // namespace wirepack
