#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace wirepack {

// Names of files and texts of files can hold anything: commands for a terminal, line breaks that
// end a comment of a script, bytes that are no UTF-8.

/// The text with '?' in place of every control character and of every byte that is not part of a
/// UTF-8 character: fit to be handed on to a terminal, a page or another program's script, within
/// quotes.
std::string plain_text(std::string_view text);
/// The same of at most so many bytes, with "..." in place of the rest.
std::string plain_text(std::string_view text, std::size_t longest);
/// Bytes of a name or a value that a message shows.
inline constexpr std::size_t bytes_in_a_message = 60;
/// The same of a text of several lines: line breaks and tabulators stay.
std::string plain_lines(std::string_view text);

}  // namespace wirepack
