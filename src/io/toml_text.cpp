#include "toml_text.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

#include "wirepack/core/error.hpp"
#include "wirepack/core/plain_text.hpp"

#include "number_hint.hpp"
#include "trimmed.hpp"

namespace wirepack {

namespace {

bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '+' || c == '-' ||
         c == '.';
}

// Dots that join names. One within a word, such as a number, is not counted: that leaves at least a
// third of all. Rows of dots join nothing.
std::size_t joining_dots(std::string_view line) {
  std::size_t dots = 0;
  while (!line.empty()) {
    const auto end = std::find_if_not(line.begin(), line.end(), is_of_word);
    const std::string_view word(line.begin(), end);
    line.remove_prefix(std::min(word.size() + 1, line.size()));
    if (word.empty() || word.find("..") != std::string_view::npos) continue;
    const auto count = static_cast<std::size_t>(std::count(word.begin(), word.end(), '.'));
    const bool within = word.front() != '.' && word.back() != '.';
    dots += count == 1 && within ? 0 : count;
  }
  return dots;
}

// A name joined by a hundred thousand dots stands for tables so deep that destroying them overflows
// the stack. Values are at most 256 deep in each other, each may be on a line of its own.
void require_shallow(std::string_view text, const std::string& source) {
  constexpr std::size_t most_dots = 32;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (joining_dots(line) > most_dots) {
      throw InvalidInput(fmt::format("{}:{}:1: names of this line are joined by more than {} dots",
                                     source, number, most_dots));
    }
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
}

bool is_bare_word(std::string_view value) {
  return !value.empty() && std::isalpha(static_cast<unsigned char>(value.front())) != 0 &&
         std::all_of(value.begin(), value.end(), is_of_word);
}

// What a line gives where it cannot be read, if that was meant as a number or a word.
std::string line_hint(std::string_view text, std::uint32_t line) {
  for (std::uint32_t i = 1; i < line && !text.empty(); ++i) {
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  }
  text = text.substr(0, text.find_first_of("\r\n#"));
  const auto equals = text.find('=');
  if (equals == std::string_view::npos) return {};
  const std::string_view name = trimmed(text.substr(0, equals));
  const std::string_view value = trimmed(text.substr(equals + 1));
  const std::string given = fmt::format("{} = {}", plain_text(name, bytes_in_a_message),
                                        plain_text(value, bytes_in_a_message));
  if (is_bare_word(value))
    return fmt::format("{}: words are in quotes; write \"{}\"", given, value);
  const std::string hint = number_hint(value);
  return hint.empty() ? std::string() : fmt::format("{}: is no number{}", given, hint);
}

}  // namespace

toml::table toml_table(std::string_view text, const std::string& source) {
  if (text.find('\0') != std::string_view::npos) {
    throw InvalidInput(source + ": is not a text file");
  }
  require_shallow(text, source);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const std::string_view said = error.description();
    const auto says = [&](std::string_view part) { return said.find(part) != said.npos; };
    std::string problem;
    if (says("utf-8")) {
      problem = "is not UTF-8; save the text as UTF-8";
    } else if (!says("redefine")) {
      problem = line_hint(text, error.source().begin.line);
    }
    if (problem.empty()) problem = plain_text(said, 300);
    throw InvalidInput(fmt::format("{}: {}", place(source, error.source()), problem));
  }
}

std::string place(const std::string& source, const toml::source_region& region) {
  return fmt::format("{}:{}:{}", source, region.begin.line, region.begin.column);
}

}  // namespace wirepack
