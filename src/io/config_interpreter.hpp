#pragma once

#include <string>
#include <vector>

#include "wirepack/io/config_file.hpp"

#include "config_text.hpp"

namespace wirepack {

/// What given keys mean. Adds what is wrong with them to the problems, a line each; nobody may use
/// the configuration then. Names of files are relative to the folder of the source, which is also
/// what messages call it.
Configuration interpreted(const ConfigText& text, const std::string& source,
                          std::vector<std::string>& problems);

}  // namespace wirepack
