#pragma once

#include <string>
#include <string_view>
#include <toml++/toml.h>

namespace wirepack {

/// The table of a user's text, in the one place that parses TOML. Throws InvalidInput,
/// "source:line:column: what is wrong", for what is none, and for names of so many parts that their
/// tables would be too deep for the stack.
toml::table toml_table(std::string_view text, const std::string& source);

/// "source:line:column", as messages begin.
std::string place(const std::string& source, const toml::source_region& region);

}  // namespace wirepack
