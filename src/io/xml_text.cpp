#include "xml_text.hpp"

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

}  // namespace wirepack
