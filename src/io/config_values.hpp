#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "config_keys.hpp"
#include "config_text.hpp"

namespace wirepack {

/// The value in the type of the key; otherwise `problem` says what is allowed. Names of shape files
/// are relative to the folder, those of overrides to their own.
std::optional<ConfigValue> converted(const ConfigKey& key, const GivenKey& given,
                                     const std::filesystem::path& folder, std::string& problem);

/// The file that a key with the name of one gives; nothing for other values.
std::optional<std::filesystem::path> named_file(const GivenKey& given,
                                                const std::filesystem::path& folder);

}  // namespace wirepack
