#include "wirepack/io/continuation.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "config_keys.hpp"
#include "config_text.hpp"

namespace wirepack {

namespace {

// How a key differs between two scenarios, or nothing.
std::optional<std::string> difference(const ConfigKey& key, const Scenario& was,
                                      const Scenario& now) {
  const auto text = [](const std::optional<ConfigValue>& value) {
    return value ? shown(*value) : std::string("not set");
  };
  const std::string before = text(key.get(was)), after = text(key.get(now));
  if (before == after) return std::nullopt;
  if (key.type == ConfigType::shape) return key.path() + ": is another one than it was";
  return fmt::format("{}: was {}, is now {}", key.path(), before, after);
}

}  // namespace

std::vector<std::string> search_changes(const Scenario& was, const Scenario& now) {
  std::vector<std::string> changes;
  for (const ConfigKey& key : config_keys()) {
    if (key.section != "minimizer" && key.section != "insertion") continue;
    if (const auto change = difference(key, was, now)) changes.push_back(*change);
  }
  return changes;
}

std::optional<std::string> continuation_conflict(const Scenario& was, const Scenario& now,
                                                 const std::vector<std::string>& given) {
  std::vector<std::string> of_user, of_defaults;
  for (const ConfigKey& key : config_keys()) {
    if (key.may_change) continue;
    const auto change = difference(key, was, now);
    if (!change) continue;
    const bool is_given = std::find(given.begin(), given.end(), key.path()) != given.end();
    (is_given ? of_user : of_defaults).push_back(*change);
  }
  of_user.insert(of_user.end(), of_defaults.begin(), of_defaults.end());
  if (of_user.empty()) return std::nullopt;
  return fmt::format("{}", fmt::join(of_user, "\n  "));
}

}  // namespace wirepack
