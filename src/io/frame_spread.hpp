#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace wirepack {

/// At most so many of the frames, evenly spread, the last one among them.
std::vector<std::int64_t> spread(const std::vector<std::int64_t>& frames, std::size_t most);

}  // namespace wirepack
