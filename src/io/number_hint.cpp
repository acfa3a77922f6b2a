#include "number_hint.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

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
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(number)) return {};
  return fmt::format("; write {:.15g}{}", number * scale, reason);
}

}  // namespace wirepack
