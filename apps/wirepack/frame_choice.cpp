#include "frame_choice.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "wirepack/core/error.hpp"

namespace wirepack {

const HistoryRow& row_of_increment(const std::vector<HistoryRow>& history, const std::string& name,
                                   std::int64_t increment) {
  for (const HistoryRow& row : history) {
    if (row.increment == static_cast<double>(increment)) return row;
  }
  throw FileError(fmt::format("{}: the history has no increment {}", name, increment));
}

std::int64_t frame_of_increment(const Hdf5Reader& reader, const std::string& name,
                                std::int64_t increment) {
  const std::vector<std::int64_t> frames = reader.frame_increments();
  if (frames.empty()) throw FileError(name + ": holds no frame yet");
  if (std::find(frames.begin(), frames.end(), increment) == frames.end()) {
    throw InvalidInput(fmt::format(
        "--frame {}: {} has no such frame; it has {} frames, of increments {} to {}: {}", increment,
        name, frames.size(), frames.front(), frames.back(), fmt::join(frames, ", ")));
  }
  return increment;
}

std::int64_t frame_at_density(const Hdf5Reader& reader, const std::string& name,
                              const std::vector<HistoryRow>& history, double density) {
  const std::vector<std::int64_t> frames = reader.frame_increments();
  if (frames.empty()) throw FileError(name + ": holds no frame yet");
  const auto distance = [&](std::int64_t frame) {
    return std::abs(row_of_increment(history, name, frame).packing_density - density);
  };
  std::int64_t nearest = frames.front();
  for (const std::int64_t frame : frames) {
    if (distance(frame) < distance(nearest)) nearest = frame;
  }
  if (distance(nearest) > reader.scenario().output.frame_every_density) {
    const auto at = [&](std::int64_t frame) {
      return row_of_increment(history, name, frame).packing_density;
    };
    throw InvalidInput(
        fmt::format("{}: has no frame at density {}; its frames are from {:.4g} to {:.4g}", name,
                    density, at(frames.front()), at(frames.back())));
  }
  return nearest;
}

}  // namespace wirepack
