#pragma once

#include <cstdint>
#include <vector>

#include "wirepack/io/hdf5_reader.hpp"

namespace wirepack {

/// The frame nearest to a density. Throws InvalidInput, with what the run has, when that lies
/// further from every frame than frames are apart.
std::int64_t frame_at_density(const Hdf5Reader& reader, const std::string& name,
                              const std::vector<HistoryRow>& history, double density);

/// The frame of this increment. Throws InvalidInput, with those of the frames, when there is
/// none.
std::int64_t frame_of_increment(const Hdf5Reader& reader, const std::string& name,
                                std::int64_t increment);

/// The row of an increment. Throws FileError when the history has none.
const HistoryRow& row_of_increment(const std::vector<HistoryRow>& history, const std::string& name,
                                   std::int64_t increment);

}  // namespace wirepack
