#pragma once

#include <CLI/App.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

namespace wirepack {

/// An option that takes one of some names, and nothing else; they stand in the help.
template <class Value, class Target>
CLI::Option* add_choice(CLI::App& app, const std::string& option, Target& target,
                        const std::string& description,
                        const std::vector<std::pair<std::string, Value>>& choices) {
  std::string names;
  for (const auto& [name, value] : choices) names += (names.empty() ? "" : "|") + name;
  const auto choose = [&target, option, names, choices](const std::string& word) {
    const auto chosen = std::find_if(choices.begin(), choices.end(),
                                     [&](const auto& choice) { return choice.first == word; });
    if (chosen == choices.end()) {
      throw CLI::ValidationError(option, fmt::format("must be {}, not {}", names, word));
    }
    target = chosen->second;
  };
  return app.add_option_function<std::string>(option, choose, description)->type_name(names);
}

}  // namespace wirepack
