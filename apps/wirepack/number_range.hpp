#pragma once

#include <CLI/Validators.hpp>
#include <fmt/format.h>
#include <string>

namespace wirepack {

/// A number between two others. Unlike CLI::Range it refuses nan.
inline CLI::Validator number_range(double smallest, double largest) {
  const auto check = [=](std::string& text) -> std::string {
    double number = 0;
    const bool allowed =
        CLI::detail::lexical_cast(text, number) && number >= smallest && number <= largest;
    return allowed ? "" : fmt::format("must be between {} and {}, not {}", smallest, largest, text);
  };
  return CLI::Validator(check, "");
}

}  // namespace wirepack
