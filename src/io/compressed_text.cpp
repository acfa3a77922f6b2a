#include "compressed_text.hpp"

#include <string_view>
#include <zlib.h>

#include "wirepack/core/error.hpp"

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

std::string base64(const std::vector<unsigned char>& bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const unsigned triple = (unsigned{bytes[i]} << 16U) |
                            (left > 1 ? unsigned{bytes[i + 1]} << 8U : 0U) |
                            (left > 2 ? unsigned{bytes[i + 2]} : 0U);
    for (unsigned digit = 0; digit < 4; ++digit) {
      text += digit <= left ? digits[(triple >> (18U - 6U * digit)) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace

std::string compressed_text(const std::vector<unsigned char>& bytes) {
  return base64(deflated(bytes));
}

}  // namespace wirepack
