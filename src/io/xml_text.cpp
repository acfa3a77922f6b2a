#include "xml_text.hpp"

namespace wirepack {

namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t'; }

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += is_control(c) ? ' ' : c;
    }
  }
  return result;
}

std::string xml_comment(std::string_view text) {
  std::string result = "<!-- ";
  for (const char c : text) {
    if (c == '-' && result.back() == '-') result += ' ';
    result += is_control(c) ? ' ' : c;
  }
  return result + " -->\n";
}

}  // namespace wirepack
