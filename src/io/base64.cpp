#include "base64.hpp"

#include <string_view>

namespace wirepack {

std::string base64(std::span<const unsigned char> bytes) {
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

}  // namespace wirepack
