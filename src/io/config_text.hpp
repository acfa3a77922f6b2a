#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "wirepack/io/config_file.hpp"

#include "config_keys.hpp"

namespace wirepack {

/// A key as it was given, before anything is known of its meaning.
struct GivenKey {
  std::string section, name;
  std::optional<ConfigValue> value;   ///< nothing for arrays, tables, dates and times
  std::string shown;                  ///< the value as messages show it
  std::string where;                  ///< "file:line:column", or the origin of an override
  bool overrides = false;             ///< given in place of the text
  std::filesystem::path folder = {};  ///< of an override: what names of files are relative to
};

struct GivenSection {
  std::string name, where;
};

struct ConfigText {
  std::vector<GivenSection> sections;
  std::vector<GivenKey> keys;         ///< in the order of the text, overrides applied
  std::vector<std::string> problems;  ///< syntax, keys outside of sections, malformed overrides
};

/// Reads TOML. Never throws on account of the text.
ConfigText read_config_text(std::string_view text, const std::string& source,
                            const std::vector<ConfigOverride>& overrides);

/// A value as messages and written configurations show it; numbers in the shortest form that reads
/// back to the same bits.
std::string shown(const ConfigValue& value);

}  // namespace wirepack
