#include "unknown_key.hpp"

#include <fmt/format.h>

#include "spelling.hpp"

namespace wirepack {

namespace {

// Names of the keys of a section, and of the sections within it, such as coil of wire.coil.
std::vector<std::string> names_in(const std::string& section, const std::vector<ConfigKey>& keys) {
  std::vector<std::string> names;
  const std::string within = section + ".";
  for (const ConfigKey& key : keys) {
    if (key.section == section) names.emplace_back(key.name);
    if (key.section.starts_with(within)) {
      const std::string inner(key.section.substr(within.size()));
      if (names.empty() || names.back() != inner) names.push_back(inner);
    }
  }
  return names;
}

}  // namespace

std::string unknown_section(const GivenSection& section, const std::vector<ConfigKey>& keys) {
  if (section.name == "sweep") {
    return "makes this a plan, for `wirepack sweep`; a configuration, as a base is, has none";
  }
  std::vector<std::string> names;
  for (const ConfigKey& key : keys) {
    if (names.empty() || names.back() != key.section) names.emplace_back(key.section);
  }
  const std::string meant = nearest(section.name, names);
  if (!meant.empty()) return fmt::format("unknown section; did you mean [{}]?", meant);
  return fmt::format("unknown section; there are [{}]", fmt::join(names, "], ["));
}

std::string unknown_key(const GivenKey& given, const std::vector<ConfigKey>& keys) {
  if (is_section(given.section + "." + given.name, keys)) {
    return fmt::format("is a section; its keys go below [{}.{}]", given.section, given.name);
  }
  const std::vector<std::string> names = names_in(given.section, keys);
  const std::string meant = nearest(given.name, names);
  if (!meant.empty()) {
    return fmt::format("unknown key; did you mean {}.{}?", given.section, meant);
  }
  for (const ConfigKey& key : keys) {
    if (key.name == given.name) return fmt::format("unknown key; did you mean {}?", key.path());
  }
  return fmt::format("unknown key; [{}] has {}", given.section, fmt::join(names, ", "));
}

}  // namespace wirepack
