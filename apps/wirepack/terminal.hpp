#pragma once

#include <string>

namespace wirepack {

/// A line on stderr. Names of files are printed as plain text: none of them commands a terminal.
void print_message(const std::string& text);
/// Lines on stdout, likewise.
void print_lines(const std::string& text);

}  // namespace wirepack
