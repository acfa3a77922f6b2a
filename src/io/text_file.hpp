#pragma once

#include <filesystem>
#include <string>

namespace wirepack {

/// The text of a file that a user names as input. Throws InvalidInput when it is missing, is not a
/// regular file, or is larger than `largest` bytes; FileError when reading it fails. `what` says in
/// messages what such a file is, with an article: "a configuration".
std::string read_text(const std::filesystem::path& file, const std::string& what,
                      std::size_t largest);

}  // namespace wirepack
