#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wirepack {

/// Runs a program of PATH in a folder, without a shell, and waits for it; its messages go where
/// ours go. Returns its exit code, of one that a signal has killed 128 and the signal's number;
/// nothing when it cannot be started.
std::optional<int> run_child_program(const std::filesystem::path& folder,
                                     std::vector<std::string> words);

}  // namespace wirepack
