#include "compressed_text.hpp"

#include <zlib.h>

#include "wirepack/core/error.hpp"

#include "base64.hpp"

namespace wirepack {

namespace {

std::vector<unsigned char> deflated(const std::vector<unsigned char>& bytes) {
  uLongf size = compressBound(bytes.size());
  std::vector<unsigned char> result(size);
  if (compress2(result.data(), &size, bytes.data(), bytes.size(), Z_BEST_COMPRESSION) != Z_OK) {
    throw FileError("zlib cannot compress a frame");
  }
  result.resize(size);
  return result;
}

}  // namespace

std::string compressed_text(const std::vector<unsigned char>& bytes) {
  return base64(deflated(bytes));
}

}  // namespace wirepack
