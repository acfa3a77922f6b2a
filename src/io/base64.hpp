#pragma once

#include <span>
#include <string>

namespace wirepack {

/// Bytes as text of RFC 4648, in one line.
std::string base64(std::span<const unsigned char> bytes);

}  // namespace wirepack
