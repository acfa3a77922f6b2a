#include "wirepack/io/config_file.hpp"

#include <fmt/format.h>

#include "config_interpreter.hpp"
#include "config_keys.hpp"
#include "config_text.hpp"
#include "problem_list.hpp"
#include "text_file.hpp"

namespace wirepack {

Configuration parse_configuration(std::string_view text, const std::string& source,
                                  const std::vector<ConfigOverride>& overrides) {
  const ConfigText given = read_config_text(text, source, overrides);
  std::vector<std::string> problems = given.problems;
  Configuration configuration;
  // What cannot be read has no keys whose values could be wrong.
  if (!given.keys.empty()) configuration = interpreted(given, source, problems);
  require_none(problems);
  return configuration;
}

Configuration read_configuration(const std::filesystem::path& file,
                                 const std::vector<ConfigOverride>& overrides) {
  constexpr std::size_t largest_file = 1'000'000;
  const std::string text = read_text(file, "a configuration", largest_file);
  Configuration configuration = parse_configuration(text, file.string(), overrides);
  configuration.inputs.insert(configuration.inputs.begin(), file);
  return configuration;
}

Scenario parse_config(std::string_view text, const std::string& source,
                      const std::vector<ConfigOverride>& overrides) {
  return parse_configuration(text, source, overrides).scenario;
}

Scenario read_config(const std::filesystem::path& file,
                     const std::vector<ConfigOverride>& overrides) {
  return read_configuration(file, overrides).scenario;
}

std::string resolved_config(const Scenario& scenario, const DeclaredUnits& units) {
  std::string text;
  std::string_view section;
  for (const ConfigKey& key : config_keys()) {
    const std::optional<ConfigValue> value = key.get(scenario);
    if (!value) continue;
    if (key.section != section) {
      section = key.section;
      text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", section);
    }
    text += fmt::format("{} = {}\n", key.name, shown(*value));
  }
  if (!units.length.empty()) {
    text += fmt::format("\n[units]\nlength = \"{}\"\nforce = \"{}\"\n", units.length, units.force);
  }
  return text;
}

}  // namespace wirepack
