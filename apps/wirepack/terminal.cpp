#include "terminal.hpp"

#include <cstdio>

#include "wirepack/core/plain_text.hpp"

namespace wirepack {

void print_message(const std::string& text) {
  std::fputs((plain_lines(text) + "\n").c_str(), stderr);
}

void print_lines(const std::string& text) { std::fputs(plain_lines(text).c_str(), stdout); }

}  // namespace wirepack
