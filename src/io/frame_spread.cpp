#include "frame_spread.hpp"

namespace wirepack {

std::vector<std::int64_t> spread(const std::vector<std::int64_t>& frames, std::size_t most) {
  if (frames.size() <= most) return frames;
  std::vector<std::int64_t> chosen;
  for (std::size_t k = 1; k <= most; ++k) chosen.push_back(frames[k * frames.size() / most - 1]);
  return chosen;
}

}  // namespace wirepack
