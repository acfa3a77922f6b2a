#include "xml_text.hpp"

#include <fmt/format.h>

#include "wirepack/core/plain_text.hpp"

namespace wirepack {

std::string xml_escaped(std::string_view text) {
  std::string result;
  for (const char c : plain_lines(text)) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += c;
    }
  }
  return result;
}

std::string xml_comment(std::string_view text) {
  std::string result = "<!-- ";
  for (const char c : plain_lines(text)) {
    if (c == '-' && result.back() == '-') result += ' ';
    result += c;
  }
  return result + " -->\n";
}

std::string relative_link(std::string_view path) {
  constexpr std::string_view kept = "-._~/=,";
  std::string link = "./";  // else a colon would end the name of a protocol
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       kept.find(c) != std::string_view::npos;
    link += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return link;
}

}  // namespace wirepack
