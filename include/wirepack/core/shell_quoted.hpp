#pragma once

#include <string>
#include <string_view>

namespace wirepack {

/// A text as one word of a shell of POSIX, which changes nothing in it: as it is where it has only
/// letters, digits and _-+=.,:/@%, else between single quotes.
std::string shell_quoted(std::string_view text);

}  // namespace wirepack
