#include "number_hint.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

#include "trimmed.hpp"

namespace wirepack {

std::string number_hint(std::string_view word) {
  std::string text(word);
  std::string reason;
  double scale = 1;
  if (!text.empty() && text.back() == '%') {
    scale = 0.01;
    text.pop_back();
    reason = " (a number has no percent sign)";
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  if (std::count(text.begin(), text.end(), ',') == 1 && text.find('.') == std::string::npos) {
    std::replace(text.begin(), text.end(), ',', '.');
    reason += " (decimals follow a point)";
  }
  double number = 0;
  const char* begin = text.data() + (!text.empty() && text.front() == '+' ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(begin, end, number);
  if (read.ec != std::errc() || !std::isfinite(number)) return {};
  const std::string_view behind = trimmed({read.ptr, end});
  if (!behind.empty()) {
    const bool is_unit = std::all_of(behind.begin(), behind.end(), [](unsigned char c) {
      return std::isalpha(c) != 0 || c > 127;  // such as micrometres in UTF-8
    });
    if (!is_unit || behind == "e" || behind == "E") return {};
    reason += " (a number has no unit behind it)";
  }
  return fmt::format("; write {:.15g}{}", number * scale, reason);
}

}  // namespace wirepack
