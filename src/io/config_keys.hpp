#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "wirepack/packing/scenario.hpp"

namespace wirepack {

/// Rows of k0(s) are written as [[s, k1, k2, k3], ...], vectors as [x, y, z].
using ConfigValue =
    std::variant<bool, std::int64_t, double, std::string, Vec3, std::vector<DarbouxRow>>;

/// Shape: rows of k0(s), or the name of a file that holds them.
enum class ConfigType { boolean, integer, number, vector, choice, shape };

/// One key of the configuration: what reading, messages and writing all go by.
struct ConfigKey {
  std::string_view section, name;
  ConfigType type = ConfigType::number;
  std::vector<std::string_view> choices;  ///< of a choice; words that may stand for a number
  std::int64_t smallest = std::numeric_limits<std::int64_t>::min();  ///< of an integer
  std::int64_t largest = std::numeric_limits<std::int64_t>::max();
  bool may_change = false;  ///< of no influence on the increments of a run
  std::function<void(Scenario&, const ConfigValue&)> set;
  /// Nothing when the key has no value: a limit that is not set.
  std::function<std::optional<ConfigValue>(const Scenario&)> get;

  std::string path() const { return std::string(section) + "." + std::string(name); }
};

/// All keys, in the order in which they are written.
std::vector<ConfigKey> config_keys();

bool is_section(std::string_view name, const std::vector<ConfigKey>& keys);

}  // namespace wirepack
