#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wirepack {

inline constexpr std::string_view must_be_positive = "must be positive and finite";

bool is_positive(double value);      ///< and finite
bool is_not_negative(double value);  ///< and finite

/// Adds "key = value: allowed" to the problems of a configuration, unless `ok`.
void require(bool ok, std::string_view key, double value, std::string_view allowed,
             std::vector<std::string>& problems);

}  // namespace wirepack
