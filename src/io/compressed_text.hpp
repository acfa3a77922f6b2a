#pragma once

#include <string>
#include <vector>

namespace wirepack {

/// Bytes as text that a page can hold: compressed (zlib format), then base64. Throws FileError when
/// zlib fails.
std::string compressed_text(const std::vector<unsigned char>& bytes);

}  // namespace wirepack
