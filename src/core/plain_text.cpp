#include "wirepack/core/plain_text.hpp"

namespace wirepack {

namespace {

unsigned char byte_at(std::string_view text, std::size_t at) {
  return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
}

// Bytes of the UTF-8 character that the text begins with; 0: it is none, or a control character.
std::size_t length_of_character(std::string_view text) {
  const unsigned char first = byte_at(text, 0), second = byte_at(text, 1);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  if (first < 0xc2 || first > 0xf4) return 0;
  const std::size_t length = first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte_at(text, k) & 0xc0) != 0x80) return 0;
  }
  // control characters of ISO 8859-1, longer codes of what has a shorter one, halves of pairs, the
  // end
  const bool wrong = (first == 0xc2 && second < 0xa0) || (first == 0xe0 && second < 0xa0) ||
                     (first == 0xed && second > 0x9f) || (first == 0xf0 && second < 0x90) ||
                     (first == 0xf4 && second > 0x8f);
  return wrong ? 0 : length;
}

std::string plain(std::string_view text, std::string_view kept) {
  std::string result;
  while (!text.empty()) {
    std::size_t length = length_of_character(text);
    if (length == 0 && kept.find(text.front()) != std::string_view::npos) length = 1;
    result += length > 0 ? text.substr(0, length) : "?";
    text.remove_prefix(length > 0 ? length : 1);
  }
  return result;
}

}  // namespace

std::string plain_text(std::string_view text) { return plain(text, ""); }

std::string plain_text(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return plain_text(text);
  // a character that would be cut in two goes as a whole
  while (longest > 0 && (byte_at(text, longest) & 0xc0) == 0x80) --longest;
  return plain_text(text.substr(0, longest)) + "...";
}

std::string plain_lines(std::string_view text) { return plain(text, "\n\t"); }

}  // namespace wirepack
