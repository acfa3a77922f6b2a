#pragma once

#include <cstdint>

namespace wirepack {

/// SplitMix64 (Steele, Lea, Flood 2014) with its own mapping to numbers, so that a seed gives the
/// same sequence with every compiler and standard library. The state is one integer: a value that
/// is stored in a checkpoint.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
  }

  /// Uniform in [-1, 1).
  double symmetric() { return static_cast<double>(next() >> 11U) * 0x1.0p-52 - 1.0; }

  std::uint64_t state() const { return state_; }

 private:
  std::uint64_t state_;
};

}  // namespace wirepack
