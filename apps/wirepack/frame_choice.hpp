#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "wirepack/packing/history.hpp"

namespace wirepack {

/// The frame nearest to a packing density among those of these increments (not empty); nothing where
/// the nearest is further away than `spacing`, as the run has not reached that density.
std::optional<std::int64_t> frame_at(double density, const std::vector<std::int64_t>& frames,
                                     const std::vector<HistoryRow>& history, double spacing);

}  // namespace wirepack
