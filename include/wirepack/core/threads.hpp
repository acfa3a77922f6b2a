#pragma once

#include <algorithm>

#include "wirepack/core/types.hpp"

namespace wirepack {

/// More are a mistake, and can end the process.
inline constexpr int most_threads = 4096;

/// How many threads computations may use from now on; without a call, as many as OpenMP is told by
/// its own environment. Results have the same bits with any number.
void use_threads(int count);

namespace detail {
void run_shared(Index count, void (*call)(void* work, Index number), void* work);
}

/// f(start, end) for the tiles of 0 ... size - 1, `width` each and the last one what is left: one
/// after the other or, if it is worth it (`shared`), by the threads at hand, in any order. Tiles
/// must not write to the same place. They do not depend on the number of threads, so neither does
/// what is computed within each.
template <class F>
void for_each_tile(Index size, Index width, bool shared, F&& f) {
  const Index count = (size + width - 1) / width;
  auto tile = [&](Index t) { f(t * width, std::min((t + 1) * width, size)); };
  if (!shared || count < 2) {
    for (Index t = 0; t < count; ++t) tile(t);
    return;
  }
  using Tile = decltype(tile);
  detail::run_shared(
      count, [](void* work, Index number) { (*static_cast<Tile*>(work))(number); }, &tile);
}

}  // namespace wirepack
