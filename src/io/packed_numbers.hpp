#pragma once

#include <cstdint>
#include <vector>

namespace wirepack {

/// Lists of numbers as bytes that compress well. Byte k of all numbers stands before byte k + 1 of
/// any (lowest first), since the high bytes are nearly the same.

std::vector<unsigned char> packed(const std::vector<float>& numbers);

/// Of the numbers, `order` times the difference to the one before is taken (modulo 2^16; the first
/// one's is to 0), and its sign moved to the lowest bit: d >= 0 becomes 2 d, d < 0 becomes -2 d -
/// 1.
std::vector<unsigned char> packed_differences(std::vector<std::int16_t> numbers, int order);

/// Each byte less the one before, modulo 256; the first one less 0.
std::vector<unsigned char> byte_differences(std::vector<unsigned char> bytes);

}  // namespace wirepack
