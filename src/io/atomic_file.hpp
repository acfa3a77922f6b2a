#pragma once

#include <filesystem>
#include <span>
#include <vector>

namespace wirepack {

/// The bytes of a file. Throws FileError.
std::vector<char> read_bytes(const std::filesystem::path& file);

/// Puts a file in place as a whole: written under a temporary name in the same folder, brought to
/// the disk, renamed; with the rights of the old one, and its owner where we may. Other names (hard
/// links) of the old one keep that. Whatever happens, `file` is the old or the new one. Throws
/// FileError with the reason (no space left, not permitted, ...); the temporary file is gone then.
void replace_file(const std::filesystem::path& file, std::span<const char> bytes);

/// Removes temporary files that replace_file() of processes of this host, which are no more, has
/// left beside `file`.
void remove_leftovers(const std::filesystem::path& file);

}  // namespace wirepack
