#pragma once

#include <array>
#include <bit>
#include <cstring>
#include <string>

namespace wirepack {

static_assert(std::endian::native == std::endian::little, "files are written little-endian");

/// Appends the bytes of a number.
template <class T>
void append_bytes(std::string& bytes, T value) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  bytes.append(raw.data(), raw.size());
}

}  // namespace wirepack
