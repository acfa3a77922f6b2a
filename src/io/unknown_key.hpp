#pragma once

#include <string>
#include <vector>

#include "config_keys.hpp"
#include "config_text.hpp"

namespace wirepack {

/// What is said of a section that there is none of: which was meant, or which there are.
std::string unknown_section(const GivenSection& section, const std::vector<ConfigKey>& keys);

/// The same of a key that its section has none of.
std::string unknown_key(const GivenKey& given, const std::vector<ConfigKey>& keys);

}  // namespace wirepack
