#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wirepack {

/// What an output may not destroy.
struct OutputRules {
  std::vector<std::filesystem::path> inputs;   ///< of the command, never replaced
  bool force = false;                          ///< replaces what is there
  std::string remedy = "--force replaces it";  ///< for the message about what is there
};

/// The place of an output file, with symbolic links followed, also to where nothing is yet. Throws
/// InvalidInput for a folder, a device or a pipe, for an input under whatever name, and, unless
/// forced, for what is there; FileError when there is no such folder, or nothing can be put in it.
std::filesystem::path output_file(const std::filesystem::path& file, const OutputRules& rules);

/// The same for files to be put in a folder, which need not be there yet.
void output_folder(const std::filesystem::path& folder, const std::vector<std::string>& files,
                   const OutputRules& rules);

/// Makes a folder, and those that it is in; false: it was there. Throws FileError.
bool make_folder(const std::filesystem::path& folder);

}  // namespace wirepack
