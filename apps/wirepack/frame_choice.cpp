#include "frame_choice.hpp"

#include <cmath>

namespace wirepack {

std::optional<std::int64_t> frame_at(double density, const std::vector<std::int64_t>& frames,
                                     const std::vector<HistoryRow>& history, double spacing) {
  const auto distance = [&](std::int64_t increment) {
    for (const HistoryRow& row : history) {
      if (row.increment == static_cast<double>(increment)) {
        return std::abs(row.packing_density - density);
      }
    }
    return density;
  };
  std::int64_t nearest = frames.front();
  for (const std::int64_t frame : frames) {
    if (distance(frame) < distance(nearest)) nearest = frame;
  }
  if (distance(nearest) > spacing) return std::nullopt;
  return nearest;
}

}  // namespace wirepack
